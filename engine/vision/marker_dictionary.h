#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace carina
{

/// The sets of ArUco and AprilTag markers that are known, by the names of the files: "4x4_50" and
/// so on, in the order of OpenCV.
enum class MarkerDictionary : std::uint8_t {
    Bits4Of50,
    Bits4Of100,
    Bits4Of250,
    Bits4Of1000,
    Bits5Of50,
    Bits5Of100,
    Bits5Of250,
    Bits5Of1000,
    Bits6Of50,
    Bits6Of100,
    Bits6Of250,
    Bits6Of1000,
    Bits7Of50,
    Bits7Of100,
    Bits7Of250,
    Bits7Of1000,
    Original,
    AprilTag16h5,
    AprilTag25h9,
    AprilTag36h10,
    AprilTag36h11,
};

inline constexpr const char* kDictionaryWords[] = {
    "4x4_50",        "4x4_100",        "4x4_250",       "4x4_1000", "5x5_50",   "5x5_100",
    "5x5_250",       "5x5_1000",       "6x6_50",        "6x6_100",  "6x6_250",  "6x6_1000",
    "7x7_50",        "7x7_100",        "7x7_250",       "7x7_1000", "original", "apriltag_16h5",
    "apriltag_25h9", "apriltag_36h10", "apriltag_36h11"};

/// Cells of a marker along a side, the black border of one cell included.
[[nodiscard]] int cellsOf(MarkerDictionary dictionary);

/// How many markers there are; their ids begin at 0.
[[nodiscard]] int sizeOf(MarkerDictionary dictionary);

/// The cells of a marker, row by row from its upper left corner: true is white.
/// @pre 0 <= id < sizeOf(dictionary)
[[nodiscard]] std::vector<bool> cellsOf(MarkerDictionary dictionary, int id);

} // namespace carina
