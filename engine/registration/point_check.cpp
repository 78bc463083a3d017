#include "engine/registration/point_check.h"

namespace carina
{
namespace
{

constexpr double kFarthest = 1e3; // metres

} // namespace

Result<void> checkPoint(const Vec3& p, const char* what)
{
    if (!p.allFinite())
        return fail(Errc::NotFinite, std::string{what} + " has a coordinate that is no number");
    if (p.cwiseAbs().maxCoeff() >= kFarthest)
        return fail(Errc::OutOfRange, std::string{what} + " is a kilometre away or more");
    return {};
}

} // namespace carina
