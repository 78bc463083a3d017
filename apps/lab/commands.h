#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// The commands of carina-lab, by the folders they are in. A new one gets its line here and in
// commands.cpp.

[[nodiscard]] Command anatomyCommand();

[[nodiscard]] Command breatheCommand();
[[nodiscard]] Command mechanicsCommand();

[[nodiscard]] Command deformCommand();

[[nodiscard]] Command driftCommand();
[[nodiscard]] Command driftNodeCommand();

[[nodiscard]] Command figuresCommand();

[[nodiscard]] Command attackCommand();
[[nodiscard]] Command carryCommand();
[[nodiscard]] Command guestsCommand();
[[nodiscard]] Command handshakeCommand();

[[nodiscard]] Command intubateCommand();

[[nodiscard]] Command fitCommand();
[[nodiscard]] Command icpCommand();
[[nodiscard]] Command pivotCommand();
[[nodiscard]] Command toolCommand();
[[nodiscard]] Command treCommand();

[[nodiscard]] Command renderCommand();

[[nodiscard]] Command sceneCommand();
[[nodiscard]] Command soakCommand();

[[nodiscard]] Command rubricCommand();

[[nodiscard]] Command summaryCommand();

[[nodiscard]] Command devicesCommand();
[[nodiscard]] Command igtlCommand();
[[nodiscard]] Command lagCommand();
[[nodiscard]] Command ndiCommand();
[[nodiscard]] Command polarisCommand();
[[nodiscard]] Command polarisRateCommand();
[[nodiscard]] Command predictCommand();
[[nodiscard]] Command probeCommand();
[[nodiscard]] Command romCommand();
[[nodiscard]] Command trackCommand();

[[nodiscard]] Command cameraCommand();
[[nodiscard]] Command printMarkersCommand();

/// All of them, in the order in which `carina-lab help` lists them.
[[nodiscard]] std::span<const Command> commands();

} // namespace carina::lab
