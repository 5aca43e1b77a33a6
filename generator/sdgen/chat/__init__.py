"""Language models behind OpenAI-compatible endpoints: asked, bounded, remembered."""
