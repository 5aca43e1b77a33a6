// Keys and buttons of the 3-D view.
"use strict";
{
  const STEP = Math.PI / 24;

  // ``hidden``: ceilings and what hangs from them.
  sdgen.controls = ({ canvas, camera, controls, tools, stage, redraw, letGo, overall, setWalls, hidden }) => {
    canvas.addEventListener("keydown", (event) => {
      const turn = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, -STEP], ArrowDown: [0, STEP] }[event.key];
      const from = camera.position.clone().sub(controls.target);
      if (turn) {
        const far = from.length(), flat = Math.atan2(from.y, from.x) + turn[0];
        const high = Math.min(Math.max(Math.acos(from.z / far) + turn[1], 0.05), 1.5);
        from.set(far * Math.sin(high) * Math.cos(flat), far * Math.sin(high) * Math.sin(flat), far * Math.cos(high));
      } else if (event.key === "+" || event.key === "=") from.multiplyScalar(0.85);
      else if (event.key === "-") from.multiplyScalar(1.18);
      else if (event.key === "Escape") letGo();
      else return;
      camera.position.copy(controls.target).add(from);
      controls.update();
      redraw();
      event.preventDefault();
    });

    const select = document.createElement("select");
    select.setAttribute("aria-label", "walls");
    for (const [value, text] of [["low", "low walls"], ["cut", "walls cut away"], ["all", "all walls"], ["none", "no walls"]]) select.add(new Option(text, value));
    select.addEventListener("change", () => setWalls(select.value));
    const ceilings = sdgen.make("button", "", "ceilings");
    ceilings.type = "button";
    ceilings.setAttribute("aria-pressed", "false");
    ceilings.addEventListener("click", () => {
      for (const one of hidden) one.visible = !one.visible;
      ceilings.setAttribute("aria-pressed", hidden[0]?.visible ?? false);
      redraw();
    });
    const whole = sdgen.make("button", "", "whole home");
    whole.type = "button";
    whole.addEventListener("click", () => { letGo(); overall(); });
    const full = sdgen.make("button", "", "full screen");
    full.type = "button";
    full.addEventListener("click", () => document.fullscreenElement ? document.exitFullscreen() : stage.requestFullscreen());
    tools.append(select, ceilings, whole, full);
  };
}
