#pragma once

#include "engine/net/devices/igtl_server.h"
#include "engine/tracking/igtl/igtl_pose.h"

namespace carina::test
{

/// An offer with a tube at (123.25, y, -30.5) mm, one landmark, and a surface of so many points.
inline std::shared_ptr<const IgtlOffer> tubeOffer(std::uint64_t stamp, double y_mm = 0.0,
                                                  std::size_t points = 3)
{
    auto offer = std::make_shared<IgtlOffer>();
    offer->stamp = stamp;
    offer->tools = {{"Tube", RigidTransform::translation({0.12325, 1e-3 * y_mm, -0.0305}), true}};
    offer->landmarks = std::make_shared<const IgtlPoints>(
        IgtlPoints{{{"Carina", "Landmark", {255, 0, 0, 255}, {1.5F, 2.5F, 3.5F}, 0, ""}}});
    auto lungs = std::make_shared<IgtlOffer::Surface>();
    lungs->name = "Lungs";
    lungs->stamp = stamp;
    lungs->data.points.resize(points, {7.25F, 8.25F, 9.25F});
    lungs->data.cells[kIgtlPolygons] = {1, {3, 0, 1, 2}};
    offer->surface = lungs;
    return offer;
}

} // namespace carina::test
