#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"

#include <QTest>

namespace carina::test
{

inline constexpr double kVolumeTolerance_ml = 0.1;
inline constexpr double kRounding = 1e-9; ///< of the range
inline constexpr PatientBuild kChild{metres(1.5), 40.0, 12.0, Sex::Female};

/// The child's lungs, coarse enough to be summed often.
inline const LungPair& childLungs()
{
    static const LungPair lungs = [] {
        Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
        for (AnatomyPart& part : anatomy.parts)
            if (lungSide(part.role))
                part.levels.erase(part.levels.begin(), part.levels.end() - 2);
        return LungPair::of(anatomy).value();
    }();
    return lungs;
}

inline double volumeDrawn_ml(const LungPair& lungs, Side side, std::size_t level,
                             const ChestPose& pose)
{
    double volume = 0.0;
    for (const BreathingPart& part : lungs.parts())
        if (part.side == side)
            volume += volumeByColumns(deformed(levelOf(part, level), lungs.field(),
                                               motionOf(part.region, pose, lungs.field())));
    return 1e6 * volume;
}

inline std::vector<ChestShape> shapesAfter(const RespiratorySettings& settings,
                                           std::initializer_list<double> seconds)
{
    RespiratoryFold fold{settings};
    std::vector<ChestShape> shapes;
    int steps = 0;
    for (const double end : seconds) {
        for (; steps < end / kRespiratoryStep; ++steps)
            fold.step();
        shapes.push_back(chestShape(settings.build, fold.system(), fold.content(), fold.moment()));
    }
    return shapes;
}

inline RespiratorySettings childWith(const LungCondition& condition)
{
    RespiratorySettings settings;
    settings.build = kChild;
    if (condition.kind != ConditionKind::Normal)
        settings.conditions = {condition};
    return settings;
}

/// A chest at rest in health, to be changed.
inline ChestShape restingShape()
{
    ChestShape shape;
    shape.lungs = {LungShape{litres(0.63), litres(0.63), litres(0.63)},
                   LungShape{litres(0.57), litres(0.57), litres(0.57)}};
    shape.ribShare = 0.4;
    return shape;
}

/// In every level, at moments of a breath and after a minute.
inline void verifyEnclosed(const RespiratorySettings& settings)
{
    const LungPair& lungs = childLungs();
    for (const ChestShape& shape : shapesAfter(settings, {0.0, 3.7, 61.0, 62.1})) {
        for (std::size_t level = 0; level < lungs.levelCount(); ++level) {
            const ChestPose pose = drawnPose(lungs, shape, level);
            QVERIFY(rangeTaken(pose) <= 1.0 + kRounding);
            for (const Side side : {Side::Right, Side::Left}) {
                const LungShape& lung = shape.lungs[indexOf(side)];
                const double expected_ml =
                    inMillilitres(lungs.restVolume(side) + lung.gas - lung.healthy);
                const double drawn_ml = volumeDrawn_ml(lungs, side, level, pose);
                QVERIFY2(std::abs(drawn_ml - expected_ml) < kVolumeTolerance_ml,
                         qPrintable(
                             QStringLiteral("%1 ml instead of %2").arg(drawn_ml).arg(expected_ml)));
            }
        }
    }
}

} // namespace carina::test
