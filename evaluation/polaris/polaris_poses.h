#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// A pose as a Polaris states it.
struct PolarisPose {
    Quat q = Quat::Identity();
    Vec3 p_mm = Vec3::Zero();
    double error_mm = 0.0;
};

/// Why a Polaris has no pose of a tool.
enum class PolarisLoss : std::uint8_t {
    Hidden,       ///< none of its markers is seen
    FewMarkers,   ///< too few are
    BadFit,       ///< they do not fit its definition
    Interference, ///< other infrared light is seen in their place
};

/// Where the markers of a tool are to the volume for which the accuracy is stated.
enum class PolarisPlace : std::uint8_t {
    Inside,
    PartlyOut, ///< some are outside
    Outside,   ///< all are: TX and BX state the pose only where option 0800 asks for it
};

/// An exposure as a Polaris saw it.
struct PolarisExposure {
    struct Tool {
        int handle = 0;
        unsigned status = 0; ///< of its port, without the volume
        std::optional<PolarisPose> pose{};
        PolarisLoss loss = PolarisLoss::Hidden; ///< where there is no pose
        bool isPlugged = true;                  ///< or wireless
        PolarisPlace place = PolarisPlace::Inside;
    };
    std::vector<Tool> tools{};
    std::vector<Vec3> strays_mm{}; ///< markers of no tool
    unsigned system = 0;           ///< status
    std::uint32_t frame = 0;
    LocalTime time{};
};

/// The answer to TX, whole. Options 0001, 0002, 0004, 0800 and 1000, as four digits.
[[nodiscard]] std::string textReply(const PolarisExposure& seen, const std::string& options);
/// The answer to BX with the same options.
[[nodiscard]] std::string binaryReply(const PolarisExposure& seen, const std::string& options);
/// The answer to BX2: the tools. A pose outside the volume is stated, with its code: the table has
/// no option that asks for it.
[[nodiscard]] std::string generalReply(const PolarisExposure& seen);

} // namespace carina
