#pragma once

#include "engine/geometry/rigid_transform.h"

#include <QFile>
#include <QRegularExpression>

#include <vector>

namespace carina::test
{

/// A pose in a reply to TX, found in the text of a file by a regular expression alone.
struct WrittenPose {
    int handle = 0;
    Vec3 p_mm;
    double error_mm = 0.0;
    unsigned frame = 0;
};

inline std::vector<WrittenPose> posesWrittenIn(const QString& path)
{
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromLatin1(file.readAll());
    text.replace(QStringLiteral("\\x0A"), QStringLiteral("\n")); // as some recordings write it
    static const QRegularExpression pose{QStringLiteral(
        "(?<![0-9A-F+-])(?:0\\d)?(0[1-9A-F])(?:[+-]\\d{5}){4}([+-]\\d{6})([+-]\\d{6})([+-]"
        "\\d{6})([+-]\\d{5})[0-9A-F]{8}([0-9A-F]{8})")};
    std::vector<WrittenPose> poses;
    for (auto matches = pose.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        const auto number = [&match](int group) { return match.captured(group).toDouble(); };
        poses.push_back({match.captured(1).toInt(nullptr, 16),
                         Vec3{number(2), number(3), number(4)} / 100.0, number(5) / 1e4,
                         match.captured(6).toUInt(nullptr, 16)});
    }
    return poses;
}

} // namespace carina::test
