#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"

#include <QJsonArray>
#include <QString>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace carina::test
{

inline constexpr double kTolerance_mm = 1e-6; // of numbers written with 12 digits
inline constexpr int kPoses = 90;
inline const Vec3 kTip_S_mm{12.0, -5.0, -152.0};
inline const Vec3 kDivot_mm{210.0, -130.0, -1800.0};
inline const RigidTransform kX_TR{rotationFromVector({0.2, 0.9, -0.4}), {100.0, -50.0, 30.0}};

/// Poses in millimetres of a stylus that leans by half a radian to all sides in its divot.
inline std::vector<RigidTransform> swung()
{
    std::vector<RigidTransform> poses;
    for (int i = 0; i < kPoses; ++i) {
        const double around = 2.0 * std::numbers::pi * i / kPoses;
        const Quat turn = rotationFromVector({0.5 * std::cos(around), 0.5 * std::sin(around), 0.0});
        poses.push_back({turn, kDivot_mm - turn * kTip_S_mm});
    }
    return poses;
}

inline std::string digits(double number)
{
    return QByteArray::number(number, 'g', 12).toStdString();
}

inline std::string tableOf(const std::vector<RigidTransform>& poses)
{
    std::string text = "tx,ty,tz,qx,qy,qz,qw\n";
    for (const RigidTransform& pose : poses) {
        const Eigen::Vector4d q = pose.rotation().coeffs();
        for (const double number : {pose.translation().x(), pose.translation().y(),
                                    pose.translation().z(), q[0], q[1], q[2]})
            text += digits(number) + ',';
        text += digits(q[3]) + '\n';
    }
    return text;
}

inline bool near(const QJsonValue& value, const Vec3& expected)
{
    const QJsonArray p = value.toArray();
    return p.size() == 3
           && (Vec3{p[0].toDouble(), p[1].toDouble(), p[2].toDouble()} - expected).norm()
                  < kTolerance_mm;
}

} // namespace carina::test
