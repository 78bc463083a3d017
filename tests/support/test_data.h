#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace carina::test
{

/// A file or folder of the real data, `relative` to their root: the folder named by
/// CARINA_TEST_DATA, else ../shared/data beside the project. std::nullopt if it is absent: the test
/// that needs it is then skipped.
inline std::optional<std::filesystem::path> testData(const std::string& relative)
{
    const char* named = std::getenv("CARINA_TEST_DATA");
    const std::filesystem::path root =
        named != nullptr && *named != '\0'
            ? std::filesystem::path{named}
            : std::filesystem::path{CARINA_SOURCE_DIR} / "../shared/data";
    std::error_code error;
    if (!std::filesystem::exists(root / relative, error))
        return std::nullopt;
    return root / relative;
}

/// In the real data: a stylus, with a reference, pivoted in eight divots.
inline constexpr const char* kEightDivots =
    "tracker/eight-landmarks/EightLandmarkPointsTrackedForPhantomRegistration.igs.mha";

} // namespace carina::test
