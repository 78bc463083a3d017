#pragma once

#include "engine/core/ids.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carina
{

/// Which parts the section of a lesson cuts.
enum class LessonCut : std::uint8_t { All, AllButAirway };
/// How parts are drawn in a lesson.
enum class LessonStyle : std::uint8_t { AsUsual, Solid, Ghost, Hidden };

/// The section plane of a lesson: points p in A with normal_A . p > distance are not drawn.
struct LessonSection {
    bool isCut = false; ///< else nothing is cut, and the rest has no effect
    LessonCut cut = LessonCut::All;
    std::array<double, 3> normal_A{0.0, 1.0, 0.0}; ///< of length 1
    double distance = 0.0;                         ///< of the plane from the origin of A, metres

    friend bool operator==(const LessonSection&, const LessonSection&) = default;
};

/// How the parts with successive numbers are drawn, the first and the last included. A part's
/// number is its place among the surfaces of the station's patient, from 1.
struct LessonLook {
    std::uint16_t first = 1;
    std::uint16_t last = 1;
    LessonStyle style = LessonStyle::AsUsual;
    bool isHighlighted = false;
    bool isNamed = false;
    bool isPlain = false; ///< in the one colour of its kind

    friend bool operator==(const LessonLook&, const LessonLook&) = default;
};

/// As many as a fact has room for.
inline constexpr std::size_t kMostLessonLooks = 120;
using LessonLooks = std::vector<LessonLook>;

/// The picture of the patient that an instructor shows to others in place of what they chose.
struct Lesson {
    LessonSection section;
    bool showsView = false; ///< also from where the instructor looks (ObjectKind::View)
    LessonLooks looks;      ///< by number; a part that is not listed is drawn as usual

    friend bool operator==(const Lesson&, const Lesson&) = default;
};

namespace fact
{

/// The author shows something at the station, in place of what was shown there before. It holds
/// until it is ended or replaced, the author leaves or comes in anew, or the station gets another
/// patient. Whoever joins while it holds is shown it as well.
struct LessonShown {
    ParticipantId to = kNobody; ///< kNobody: everybody at the station
    Lesson lesson;

    friend bool operator==(const LessonShown&, const LessonShown&) = default;
};
/// Nothing is shown at the station any more.
struct LessonEnded {
    friend bool operator==(const LessonEnded&, const LessonEnded&) = default;
};

} // namespace fact

} // namespace carina
