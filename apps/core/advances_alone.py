"""advances_alone.py FONT OUT: a font whose text can be measured, and not drawn: every letter with its width, the outline of
H alone, whose height is that of capitals."""

import sys

from fontTools.ttLib import TTFont
from fontTools.ttLib.tables._g_l_y_f import Glyph

font = TTFont(sys.argv[1], recalcBBoxes=False, recalcTimestamp=False)
for name in font.getGlyphOrder():
    if name != font.getBestCmap()[ord('H')]:
        font['glyf'][name] = Glyph()
for table in ('GDEF', 'GPOS', 'GSUB', 'name', 'OS/2', 'post', 'gasp', 'cvt ', 'fpgm', 'prep'):
    if table in font:
        del font[table]
font.save(sys.argv[2])
