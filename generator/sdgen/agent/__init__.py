"""An agent in a home: it walks, looks, opens, reports, and mends."""
