#pragma once

#include <QCoreApplication>

#include <memory>

namespace carina::lab
{

/// The application object that a command which draws needs. `argc` must outlive it.
[[nodiscard]] std::unique_ptr<QCoreApplication> drawingApplication(int& argc, char** argv);

} // namespace carina::lab
