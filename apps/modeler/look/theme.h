/// @file theme.h
/// Colours, spacing and the dark style, in one place.
#pragma once

#include <QColor>

class QApplication;

namespace sinew::modeler::theme {

inline const QColor window{0x2b, 0x2e, 0x35};
inline const QColor panel{0x23, 0x26, 0x2c};
inline const QColor field{0x1b, 0x1d, 0x22};
inline const QColor border{0x3b, 0x40, 0x4a};
inline const QColor text{0xe4, 0xe7, 0xec};
inline const QColor dim_text{0x98, 0xa0, 0xad};
inline const QColor accent{0x4f, 0x8f, 0xdc};
inline const QColor error{0xf0, 0x75, 0x6c};
inline const QColor warning{0xe8, 0xa5, 0x4a};
inline const QColor fine{0x62, 0xc9, 0x88};

inline const QColor viewport_top{0x3c, 0x41, 0x4b};
inline const QColor viewport_bottom{0x24, 0x27, 0x2d};
inline const QColor grid{200, 208, 222};
inline const QColor glass{20, 22, 26, 190};  ///< behind text over the scene
inline const QColor active{255, 240, 176};
inline const QColor selected{255, 214, 92};
inline const QColor snap{96, 230, 150};
inline const QColor axis[3] = {{236, 88, 96}, {120, 200, 88}, {84, 148, 250}};

inline constexpr int gap = 6;  ///< between things that belong together, logical pixels

/// Palette and style sheet of the whole program.
void apply(QApplication& application);

}  // namespace sinew::modeler::theme
