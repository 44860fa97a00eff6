// The colours of all pictures. One thing has one colour everywhere: blue is what the robot believes, red is the
// reflection of that, amber is the truth, magenta are view particles.
#pragma once

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures::palette {

inline constexpr Color page{251, 251, 249};
inline constexpr Color ink{36, 42, 51};
inline constexpr Color faint_ink{112, 120, 131};
inline constexpr Color grid{226, 229, 232};
inline constexpr Color plate{207, 212, 218};  ///< behind histograms: black and white both stand out
inline constexpr Color empty_plate{236, 238, 240};

inline constexpr Color carpet{104, 156, 104};
inline constexpr Color carpet_border{92, 142, 93};
inline constexpr Color field_line{250, 252, 250};

inline constexpr Color truth{255, 179, 0};
inline constexpr Color belief{21, 88, 214};
inline constexpr Color opposite{212, 48, 52};
inline constexpr Color pose_particle{44, 50, 58};
inline constexpr Color view_particle{224, 0, 168};
inline constexpr Color cluster{120, 126, 134};
inline constexpr Color goal_area{0, 150, 136};
inline constexpr Color percept{0, 214, 255};  ///< what was found in the image
inline constexpr Color obstacle{255, 96, 32};

}  // namespace reorient::pictures::palette
