#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace carina
{

using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Quat = Eigen::Quaterniond;

} // namespace carina
