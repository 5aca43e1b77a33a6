"""Light in a home, found by rays: sun and sky through windows, lamps, and what walls give on."""
