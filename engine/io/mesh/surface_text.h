#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// Information about a surface in the comments of its file, as in those of BodyParts3D.
struct SurfaceNotes {
    std::string name;                      ///< from "English name : Trachea"
    std::string conceptId;                 ///< from "Concept ID : FMA7394"
    std::vector<std::string> attributions; ///< comments about licence or copyright
};

/// Reads the comments among the first lines of an OBJ ("# ...") or PLY ("comment ...") text.
[[nodiscard]] SurfaceNotes notesIn(std::string_view text);

/// The first "FMA" followed by digits: "FMA7394" of "Trachea_FMA7394.001".
[[nodiscard]] std::optional<std::string> conceptIn(std::string_view text);

/// Whether a line is about a licence or copyright.
[[nodiscard]] bool isAttribution(std::string_view line);

/// Removes the first line from `text` and returns it without its line end.
[[nodiscard]] std::string_view takeLine(std::string_view& text);

/// Removes the first word from `line` and returns it; empty at the end.
[[nodiscard]] std::string_view takeWord(std::string_view& line);

} // namespace carina
