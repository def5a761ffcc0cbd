// A table a tile in global memory: kTilePixels slots of a surface and its pixels, then the entry of its next pixel.
UPDATES(3, uint, table_surfaces);
UPDATES(4, uint, table_pixels);
