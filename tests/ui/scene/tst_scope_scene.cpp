#include "ui/scene/scope_scene.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/support/deformed_tissue.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::scope_scene_test
{
namespace
{

using test::deformed;

/// How far a middle may lie from where the blade takes it.
constexpr double kBeside_mm = 2.5;

const PatientModel& adult()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::Adult).value()).value();
    return *made;
}

BladeField fullLift()
{
    const auto scope = Laryngoscopy::of(adult(), bladeOf(kUsualBlade)).value();
    return scope.pose(LaryngoscopyStep::Full, kUsualLift).field;
}

/// The middles of the triangles of a surface, as vertices.
TriangleMesh middlesOf(const TriangleMesh& mesh)
{
    TriangleMesh middles;
    for (const auto& [i, j, k] : mesh.triangles) {
        middles.positions.push_back((mesh.positions[i] + mesh.positions[j] + mesh.positions[k])
                                    / 3.0F);
        middles.normals.push_back(mesh.normals[i]);
    }
    return middles;
}

/// The farthest that the middle of a triangle is, as drawn, from where the blade takes the tissue
/// there.
double farthestBeside_mm(const TriangleMesh& mesh, const BladeField& blade, AirwayTissue tissue)
{
    const TriangleMesh drawn = middlesOf(deformed(mesh, blade, tissue));
    const TriangleMesh taken = deformed(middlesOf(mesh), blade, tissue);
    double most = 0.0;
    for (std::size_t i = 0; i < drawn.positions.size(); ++i)
        most = std::max(most, double((drawn.positions[i] - taken.positions[i]).norm()));
    return 1e3 * most;
}

} // namespace

class TestScopeScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// However little time there is: a coarse tongue would hang over the blade.
    void bendsAroundTheBladeInEachLevel()
    {
        TissueColors colors;
        const ScopeScene scene = scopeScene(adult(), bladeOf(kUsualBlade), colors);
        const BladeField blade = fullLift();
        int coarser = 0;
        for (const ScenePart& part : scene.parts) {
            const auto tissue = airwayTissueOf(part.region);
            const bool isBehindMucosa = part.name.ends_with("cartilage");
            if (!tissue || (only(*tissue) & kThroatTissues) == 0 || isBehindMucosa)
                continue;
            QVERIFY(!part.deviations.empty());
            for (std::size_t level = 0; level < part.deviations.size(); ++level) {
                const double beside = farthestBeside_mm(*part.levels[level], blade, *tissue);
                QVERIFY2(beside < kBeside_mm, qPrintable(QStringLiteral("%1, level %2: %3 mm")
                                                             .arg(QString::fromStdString(part.name))
                                                             .arg(level)
                                                             .arg(beside)));
                coarser += level > 0 ? 1 : 0;
            }
        }
        QVERIFY(coarser > 0); // time is still saved
    }
};

CARINA_TEST(TestScopeScene)

} // namespace carina::scope_scene_test

#include "tst_scope_scene.moc"
