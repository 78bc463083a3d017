#include "engine/vision/printed_tools.h"

namespace carina
{
namespace
{

RigidTransform shifted(double x_mm, double y_mm)
{
    return RigidTransform::translation({1e-3 * x_mm, 1e-3 * y_mm, 0.0});
}

PrintedTool chest()
{
    PrintedTool tool{.name = "Manikin",
                     .role = ToolRole::Manikin,
                     .width = millimetres(160.0),
                     .height = millimetres(110.0)};
    const double side = 0.036;
    tool.body = {{0, side, shifted(-50.0, 28.0)},
                 {1, side, shifted(50.0, 28.0)},
                 {2, side, shifted(50.0, -28.0)},
                 {3, side, shifted(-50.0, -28.0)}};
    return tool;
}

PrintedTool chin()
{
    PrintedTool tool{.name = "Chin",
                     .role = ToolRole::Jaw,
                     .width = millimetres(80.0),
                     .height = millimetres(40.0)};
    tool.body = {{4, 0.028, shifted(-20.0, 0.0)}, {5, 0.028, shifted(20.0, 0.0)}};
    return tool;
}

/// Four faces with a marker each, its side 3/4 of the face. The hole is for what it is pushed over:
/// a connector of 15 mm (ISO 5356), a pencil of 7 mm, the handle of a laryngoscope of 28 mm (ours).
PrintedTool sleeve(const char* name, ToolRole role, int firstId, Length face, Length hole)
{
    PrintedTool tool{
        .name = name, .role = role, .isSleeve = true, .width = face, .height = face, .hole = hole};
    const double half = 0.5 * face.si;
    for (int i = 0; i < 4; ++i) {
        const Quat turn{Eigen::AngleAxisd{degrees(90.0 * i).si, Vec3::UnitZ()}};
        Mat3 R_BK; // of the face that looks along +x: right is +y, up is +z
        R_BK << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
        const RigidTransform X_BK{turn * Quat{R_BK},
                                  turn * Vec3{half, 0.0, 0.0} + half * Vec3::UnitZ()};
        tool.body.push_back({firstId + i, 0.75 * face.si, X_BK});
    }
    return tool;
}

} // namespace

const std::vector<PrintedTool>& printedTools()
{
    static const std::vector<PrintedTool> tools{
        chest(), chin(), sleeve("Tube", ToolRole::Tube, 6, millimetres(36.0), millimetres(15.0)),
        sleeve("Stylus", ToolRole::Stylus, 10, millimetres(36.0), millimetres(7.0)),
        sleeve("Laryngoscope", ToolRole::Laryngoscope, 14, millimetres(40.0), millimetres(29.0))};
    return tools;
}

} // namespace carina
