#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// What the comments of a surface file say about the surface, as BodyParts3D and others write them.
struct SurfaceNotes {
    std::string name;                      ///< of "English name : Trachea"
    std::string conceptId;                 ///< of "Concept ID : FMA7394"
    std::vector<std::string> attributions; ///< comments that speak of a licence or of copyright
};

/// Reads the comments among the first lines of an OBJ ("# ...") or PLY ("comment ...") text.
[[nodiscard]] SurfaceNotes notesIn(std::string_view text);

/// The first "FMA" with digits after it: "FMA7394" of "Trachea_FMA7394.001".
[[nodiscard]] std::optional<std::string> conceptIn(std::string_view text);

/// Whether a line speaks of a licence or of copyright.
[[nodiscard]] bool isAttribution(std::string_view line);

/// The next line without its end, taken off the front of `text`.
[[nodiscard]] std::string_view takeLine(std::string_view& text);

/// The next word, taken off the front of `line`; empty at the end.
[[nodiscard]] std::string_view takeWord(std::string_view& line);

} // namespace carina
