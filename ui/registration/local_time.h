#pragma once

#include <QDateTime>
#include <QString>

#include <string>

namespace carina
{

/// Converts an ISO 8601 time of a site file to local time, "yyyy-MM-dd HH:mm"; a text that is no
/// time is returned as it is.
inline QString localTime(const std::string& time)
{
    const auto at = QDateTime::fromString(QString::fromStdString(time), Qt::ISODate);
    return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                        : QString::fromStdString(time);
}

} // namespace carina
