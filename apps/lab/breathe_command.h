#pragma once

#include "apps/lab/command.h"

#include <QCoreApplication>

#include <memory>

namespace carina::lab
{

/// `breathe`: how well the volume of the lungs drawn follows the volume commanded.
[[nodiscard]] Command breatheCommand();

/// The application object that a command which draws needs. `argc` must outlive it.
[[nodiscard]] std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv);

} // namespace carina::lab
