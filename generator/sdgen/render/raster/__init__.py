"""Our own OpenGL: a scene's triangles in one pass into colours, ids, normals and depth."""
