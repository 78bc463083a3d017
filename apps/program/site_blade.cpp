#include "apps/program/site_blade.h"

namespace carina::program
{

FigureShapes::Mesh bladeOf(const SharedTools& tools)
{
    const auto blade = tools.blade();
    if (!blade)
        return nullptr;
    return std::make_shared<const TriangleMesh>(bladeMesh({.reach = -blade->p_L_tip.z(),
                                                           .rise = blade->p_L_tip.y(),
                                                           .sag = blade->sag().si,
                                                           .width = blade->heelWidth.si}));
}

} // namespace carina::program
