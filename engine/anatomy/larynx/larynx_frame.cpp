#include "engine/anatomy/larynx/larynx_frame.h"

#include "engine/anatomy/airway/airway_shapes.h"

#include <utility>

namespace carina
{

LarynxFrame::LarynxFrame(const PatientDimensions& dimensions)
    : m_X_AW(windpipeInAnatomy()),
      m_X_WA(m_X_AW.inverse()),
      m_p_W(dimensions.cordsToCarina.si * Vec3::UnitZ()),
      m_below((dimensions.cordsToCarina.si - dimensions.tracheaLength.si) / -kTracheaTop_mm),
      m_unit(dimensions.larynxGirth * m_below)
{
}

Box LarynxFrame::inAnatomy(const Box& box_mm) const
{
    Box box;
    for (const double x : {box_mm.min.x(), box_mm.max.x()})
        for (const double y : {box_mm.min.y(), box_mm.max.y()})
            for (const double z : {box_mm.min.z(), box_mm.max.z()})
                box.include(inAnatomy(Vec3{x, y, z}));
    return box;
}

ImplicitShape LarynxFrame::inAnatomy(const Box& box_mm, Implicit local) const
{
    return {inAnatomy(box_mm), [frame = *this, local = std::move(local)](const Vec3& p_A) {
                return frame.m_unit * local(frame.local(p_A));
            }};
}

} // namespace carina
