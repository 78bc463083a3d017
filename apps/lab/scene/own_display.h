#pragma once

#include "engine/core/result.h"

#include <QProcess>
#include <QSize>
#include <QStringList>

namespace carina::lab
{

/// A display of its own for a program, which no other window covers: an Xvfb that picks its number
/// itself, and ends with this.
class OwnDisplay
{
public:
    OwnDisplay() = default;
    ~OwnDisplay();
    OwnDisplay(const OwnDisplay&) = delete;
    OwnDisplay& operator=(const OwnDisplay&) = delete;

    /// @returns NoGraphics where there is no Xvfb, or it does not start
    [[nodiscard]] Result<void> start(const QSize& size);
    /// The command line that has a program draw here, in software.
    [[nodiscard]] QStringList on(const QStringList& program) const;

private:
    QProcess m_server;
    QByteArray m_number;
};

} // namespace carina::lab
