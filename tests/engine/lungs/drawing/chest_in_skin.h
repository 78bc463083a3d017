#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_build.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace carina::test
{

inline constexpr Length kMostOutside = millimetres(1.0);
/// An edge that is drawn so many times as long as at rest is torn.
inline constexpr double kTorn = 2.5;
/// Of breathing in one way, after which a breath is looked at.
inline constexpr double kMinute_s = 60.0;
inline constexpr double kTenMinutes_s = 600.0;

/// What a part of the chest is drawn like beside the skin.
struct DrawnSurface {
    Length outside;       ///< of the vertex that is farthest outside the skin; 0 where none is
    double stretch = 1.0; ///< of the edge that is longest for its length at rest
};

/// A patient whose lungs, diaphragm and skin are drawn in their coarsest level.
class SkinnedChest
{
public:
    explicit SkinnedChest(const PatientParameters& patient)
        : m_anatomy{patientFor(patient).value()}, m_lungs{LungPair::of(m_anatomy).value()}
    {
    }

    [[nodiscard]] const LungPair& lungs() const { return m_lungs; }
    [[nodiscard]] std::size_t level() const { return m_lungs.levelCount() - 1; }

    /// The worst of diaphragm and lungs in a pose.
    [[nodiscard]] DrawnSurface drawn(const ChestPose& pose) const
    {
        const TriangleMesh skin = inPose(partOf(PartRole::Skin), pose);
        const SurfaceTree tree{skin};
        DrawnSurface worst;
        for (const AnatomyPart& part : m_anatomy.parts) {
            if (part.role != PartRole::Diaphragm && !lungSide(part.role))
                continue;
            const TriangleMesh moved = inPose(part, pose);
            worst.outside = std::max(worst.outside, outside(moved, skin, tree));
            worst.stretch = std::max(worst.stretch, stretch(part.levels.back(), moved));
        }
        return worst;
    }

    /// Where the trachea is in a pose, from where it is at rest: its vertex nearest to the carina.
    [[nodiscard]] Vec3 carinaMoved(const ChestPose& pose) const
    {
        const std::vector<Vec3f>& trachea = partOf(PartRole::Trachea).levels.back().positions;
        const Vec3 p_A = std::ranges::min_element(trachea, {}, &Vec3f::squaredNorm)->cast<double>();
        return m_lungs.field()
            .at(p_A, motionOf(ChestRegion::Mediastinum, pose, m_lungs.field()))
            .d_A;
    }

    /// How far the diaphragm of a side goes down on average.
    [[nodiscard]] Length descent(const ChestPose& pose, Side side) const
    {
        const AnatomyPart& diaphragm = partOf(PartRole::Diaphragm);
        const TriangleMesh moved = inPose(diaphragm, pose);
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < moved.positions.size(); ++i) {
            const Vec3f& p_A = diaphragm.levels.back().positions[i];
            if ((p_A.x() < 0.0F) != (side == Side::Right))
                continue;
            sum += double(p_A.z()) - double(moved.positions[i].z());
            ++count;
        }
        return metres(sum / count);
    }

private:
    [[nodiscard]] const AnatomyPart& partOf(PartRole role) const
    {
        return *std::ranges::find(m_anatomy.parts, role, &AnatomyPart::role);
    }
    [[nodiscard]] TriangleMesh inPose(const AnatomyPart& part, const ChestPose& pose) const
    {
        return deformed(part.levels.back(), m_lungs.field(),
                        motionOf(regionOf(part.role), pose, m_lungs.field()));
    }
    /// Whether a closed surface winds around a point: the solid angle that it fills there.
    static bool encloses(const TriangleMesh& surface, const Vec3& p)
    {
        double angle = 0.0;
        for (const auto& [i, j, k] : surface.triangles) {
            const Vec3 a = (surface.positions[i].cast<double>() - p).normalized();
            const Vec3 b = (surface.positions[j].cast<double>() - p).normalized();
            const Vec3 c = (surface.positions[k].cast<double>() - p).normalized();
            angle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
        }
        return angle > 2.0 * std::numbers::pi;
    }
    static Length outside(const TriangleMesh& mesh, const TriangleMesh& skin,
                          const SurfaceTree& tree)
    {
        double most = 0.0;
        for (const Vec3f& position : mesh.positions) {
            const Vec3 p_A = position.cast<double>();
            const SurfacePoint nearest = tree.nearestTo(p_A).value();
            const Vec3 from = p_A - nearest.p;
            if (from.norm() > most && from.dot(nearest.normal) > 0.0 && !encloses(skin, p_A))
                most = from.norm();
        }
        return metres(most);
    }
    static double stretch(const TriangleMesh& rest, const TriangleMesh& moved)
    {
        constexpr float kShortest_m = 3e-3F; // shorter ones are too small to be seen torn
        double most = 1.0;
        for (const Triangle& triangle : rest.triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const auto from = triangle[corner];
                const auto to = triangle[(corner + 1) % 3];
                const float before = (rest.positions[from] - rest.positions[to]).norm();
                const float after = (moved.positions[from] - moved.positions[to]).norm();
                if (before > kShortest_m)
                    most = std::max(most, double(after / before));
            }
        }
        return most;
    }

    Anatomy m_anatomy;
    LungPair m_lungs;
};

/// Whether gas goes on for minutes: into the pleura, or out of a lung that a tube has closed off.
inline bool developsForMinutes(ConditionKind kind)
{
    return kind == ConditionKind::TensionPneumothorax || kind == ConditionKind::MainstemIntubation;
}

/// What the mechanics give at the ends of a breath, after so long a time of breathing in this way:
/// with the least gas in the lungs and with the most.
inline std::array<ChestShape, 2> endsOfSettledBreath(const RespiratorySettings& settings,
                                                     double settled_s = kMinute_s)
{
    constexpr int kLooks = 10;
    RespiratoryFold fold{settings};
    const auto run = [&fold](double seconds) {
        for (int step = 0; step < std::lround(seconds / kRespiratoryStep); ++step)
            fold.step();
    };
    const auto gas = [](const ChestShape& shape) {
        return shape.lungs[0].gas.si + shape.lungs[1].gas.si;
    };
    run(settled_s);
    std::vector<ChestShape> shapes;
    for (int look = 0; look < kLooks; ++look) {
        shapes.push_back(chestShape(settings.build, fold.system(), fold.content(), fold.moment()));
        run(1.0 / settings.pattern.rate.si / kLooks);
    }
    const auto [least, most] = std::ranges::minmax_element(shapes, {}, gas);
    return {*least, *most};
}

/// Within the skin and whole at both ends of a breath.
inline void verifyInSkin(const SkinnedChest& chest, const RespiratorySettings& settings,
                         const QString& what, double settled_s = kMinute_s)
{
    for (const ChestShape& shape : endsOfSettledBreath(settings, settled_s)) {
        const DrawnSurface drawn = chest.drawn(drawnPose(chest.lungs(), shape, chest.level()));
        QVERIFY2(drawn.outside <= kMostOutside,
                 qPrintable(QStringLiteral("%1: %2 mm outside the skin")
                                .arg(what)
                                .arg(inMillimetres(drawn.outside))));
        QVERIFY2(drawn.stretch < kTorn,
                 qPrintable(QStringLiteral("%1: an edge %2 times as long as at rest")
                                .arg(what)
                                .arg(drawn.stretch)));
    }
}

} // namespace carina::test
