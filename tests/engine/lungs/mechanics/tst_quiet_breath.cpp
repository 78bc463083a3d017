#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace carina::quiet_breath_test
{

namespace
{

constexpr double kSettled_s = 60.0;
constexpr double kBreath_s = 6.0; ///< at least one

double gas_l(const ChestShape& shape) { return inLitres(shape.lungs[0].gas + shape.lungs[1].gas); }

/// A built-in patient who breathes quietly, lying down, as drawn at the ends of a breath.
struct QuietBreath {
    Anatomy anatomy;
    LungPair lungs;
    ChestShape exhaled{};
    ChestShape inhaled{};

    [[nodiscard]] double tidal_l() const { return gas_l(inhaled) - gas_l(exhaled); }
};

QuietBreath quietBreath(BuiltinPatient patient)
{
    Anatomy anatomy = builtinPatient(patient).value();
    LungPair lungs = LungPair::of(anatomy).value();
    RespiratorySettings settings;
    settings.build = buildOf(dimensionsOf(patient));
    settings.pattern = restingPattern(settings.build);
    RespiratoryFold fold{settings};
    const auto now = [&] {
        return chestShape(settings.build, fold.system(), fold.content(), fold.moment());
    };
    for (int step = 0; step < kSettled_s / kRespiratoryStep; ++step)
        fold.step();
    QuietBreath breath{std::move(anatomy), std::move(lungs), now(), now()};
    for (int step = 0; step < kBreath_s / kRespiratoryStep; ++step) {
        fold.step();
        const ChestShape shape = now();
        if (gas_l(shape) < gas_l(breath.exhaled))
            breath.exhaled = shape;
        if (gas_l(shape) > gas_l(breath.inhaled))
            breath.inhaled = shape;
    }
    return breath;
}

const QuietBreath& breathOf(const QString& patient)
{
    static const QuietBreath adult = quietBreath(BuiltinPatient::Adult);
    static const QuietBreath child = quietBreath(BuiltinPatient::TwelveYears);
    return patient == QStringLiteral("child") ? child : adult;
}

/// Where the surface of a part is at the end of expiration, and how far it goes in.
struct Facet {
    Vec3 p_mm;
    Vec3 area_cm2;
    Vec3 moved_mm;
};

std::vector<Facet> facetsOf(const QuietBreath& breath, PartRole role)
{
    const ChestField& field = breath.lungs.field();
    const ChestMotion before =
        motionOf(regionOf(role), drawnPose(breath.lungs, breath.exhaled, 0), field);
    const ChestMotion after =
        motionOf(regionOf(role), drawnPose(breath.lungs, breath.inhaled, 0), field);
    std::vector<Facet> facets;
    for (const AnatomyPart& part : breath.anatomy.parts) {
        if (part.role != role)
            continue;
        const TriangleMesh exhaled = deformed(part.levels[0], field, before);
        const TriangleMesh inhaled = deformed(part.levels[0], field, after);
        for (const auto& [i, j, k] : exhaled.triangles) {
            const auto corner = [&](const TriangleMesh& mesh, std::uint32_t vertex) {
                return Vec3{1e3 * mesh.positions[vertex].cast<double>()};
            };
            const Vec3 a = corner(exhaled, i);
            const Vec3 b = corner(exhaled, j);
            const Vec3 c = corner(exhaled, k);
            const Vec3 went = corner(inhaled, i) + corner(inhaled, j) + corner(inhaled, k);
            facets.push_back(
                {(a + b + c) / 3.0, 0.005 * (b - a).cross(c - a), (went - a - b - c) / 3.0});
        }
    }
    return facets;
}

/// How far the upper face of the diaphragm goes down.
struct Excursion {
    double dome_mm = 0.0;   ///< where it is highest, the mean of both sides
    double mean_mm = 0.0;   ///< of its area
    double behind_mm = 0.0; ///< of the third of the domes that lies furthest behind
};

Excursion excursionOf(const QuietBreath& breath)
{
    std::multimap<double, const Facet*> byDepth; // towards the back
    std::array<const Facet*, 2> domes{};
    double area = 0.0;
    double volume = 0.0;
    const std::vector<Facet> facets = facetsOf(breath, PartRole::Diaphragm);
    for (const Facet& facet : facets) {
        if (facet.area_cm2.z() <= 0.0)
            continue;
        area += facet.area_cm2.z();
        volume -= facet.area_cm2.z() * facet.moved_mm.z();
        const bool isFlat = facet.area_cm2.z() > 0.5 * facet.area_cm2.norm();
        if (!isFlat || std::abs(facet.p_mm.x()) < 20.0)
            continue;
        byDepth.emplace(facet.p_mm.y(), &facet);
        const Facet*& dome = domes[facet.p_mm.x() < 0.0 ? 0 : 1];
        if (dome == nullptr || facet.p_mm.z() > dome->p_mm.z())
            dome = &facet;
    }
    Excursion excursion;
    excursion.dome_mm = -0.5 * (domes[0]->moved_mm.z() + domes[1]->moved_mm.z());
    excursion.mean_mm = volume / area;
    double areaBehind = 0.0;
    auto facet = byDepth.rbegin();
    for (std::size_t i = 0; i < byDepth.size() / 3; ++i, ++facet) {
        areaBehind += facet->second->area_cm2.z();
        excursion.behind_mm -= facet->second->area_cm2.z() * facet->second->moved_mm.z();
    }
    excursion.behind_mm /= areaBehind;
    return excursion;
}

/// How high the ribs of an ordinal meet their cartilages' front, before the breath.
double frontEnd_mm(const QuietBreath& breath, const char* rib)
{
    Vec3f foremost = Vec3f::Zero();
    for (const AnatomyPart& part : breath.anatomy.parts)
        if (part.name.ends_with(rib))
            for (const Vec3f& p : part.levels[0].positions)
                if (p.y() < foremost.y())
                    foremost = p;
    return 1e3 * double{foremost.z()};
}

/// The outermost facets all around a chest at one height, one for each marker that would be there
/// if 36 were put around it.
std::vector<Facet> markersAt(double height_mm, const std::vector<Facet>& ribs)
{
    constexpr double kMarkers = 36.0;
    constexpr double kNear_mm = 8.0;
    constexpr double kMiddle_mm = 20.0; // of the chest, behind the carina
    const auto fromMiddle = [](const Facet& facet) {
        return std::complex<double>{facet.p_mm.x(), facet.p_mm.y() - kMiddle_mm};
    };
    std::map<double, const Facet*> outermost;
    for (const Facet& facet : ribs) {
        if (std::abs(facet.p_mm.z() - height_mm) > kNear_mm)
            continue;
        const double turns = std::arg(fromMiddle(facet)) / (2.0 * std::numbers::pi);
        const Facet*& known = outermost[std::floor(kMarkers * turns)];
        if (known == nullptr || std::abs(fromMiddle(facet)) > std::abs(fromMiddle(*known)))
            known = &facet;
    }
    std::vector<Facet> markers;
    for (const auto& [place, facet] : outermost)
        markers.push_back(*facet);
    return markers;
}

} // namespace

/// Figures: physiology of adults and children, lying down unless something else is said.
class TestQuietBreath : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lowersTheDomesAsFluoroscopyFound_data() { patients(); }
    void lowersTheDomesAsFluoroscopyFound();
    void lowersTheBackOfTheDomesAsUltrasoundFound();
    void lowersTheDiaphragmByWhatItTakesIn_data() { patients(); }
    void lowersTheDiaphragmByWhatItTakesIn();
    void movesTheRibsAsMarkersWent_data() { patients(); }
    void movesTheRibsAsMarkersWent();

private:
    void patients();
};

void TestQuietBreath::patients()
{
    QTest::addColumn<QString>("patient");
    QTest::newRow("adult") << QStringLiteral("adult");
    QTest::newRow("child") << QStringLiteral("child");
}

// 16.6 +- 2.4 mm/L in adults, independent of height and weight: within two standard deviations.
void TestQuietBreath::lowersTheDomesAsFluoroscopyFound()
{
    QFETCH(QString, patient);
    const QuietBreath& breath = breathOf(patient);
    const double perLitre_mm = excursionOf(breath).dome_mm / breath.tidal_l();
    qInfo("%.1f mm/L", perLitre_mm);
    QVERIFY(std::abs(perLitre_mm - 16.6) < 4.8);
}

// 18 +- 3 mm in adults who breathe quietly: within one standard deviation.
void TestQuietBreath::lowersTheBackOfTheDomesAsUltrasoundFound()
{
    const double behind_mm = excursionOf(breathOf(QStringLiteral("adult"))).behind_mm;
    qInfo("%.1f mm", behind_mm);
    QVERIFY(std::abs(behind_mm - 18.0) < 3.0);
}

// 60 % of the breath over 250 to 300 cm2: 10 to 13 mm for half a litre in an adult. A child has an
// area less by the two-thirds power of lung size; a child's diaphragm makes 55 % of a breath, a
// man's 65 %.
void TestQuietBreath::lowersTheDiaphragmByWhatItTakesIn()
{
    QFETCH(QString, patient);
    const bool isChild = patient == QStringLiteral("child");
    const double area = isChild ? std::pow(1.2 / 2.31, 2.0 / 3.0) : 1.0;
    const double share = (isChild ? 0.55 : 0.65) / 0.6;
    const QuietBreath& breath = breathOf(patient);
    const double asTheMean_mm = excursionOf(breath).mean_mm * 0.5 / breath.tidal_l() * area / share;
    qInfo("%.1f mm", asTheMean_mm);
    QVERIFY(asTheMean_mm > 10.0 && asTheMean_mm < 13.0);
}

// Markers around the chest at the third and fifth costal cartilage went 3 to 5 mm forward and as
// far up in the mean, and 1 to 2 mm outward (five adults, seated).
void TestQuietBreath::movesTheRibsAsMarkersWent()
{
    QFETCH(QString, patient);
    const QuietBreath& breath = breathOf(patient);
    const std::vector<Facet> ribs = facetsOf(breath, PartRole::Rib);
    double forward_mm = 0.0;
    double upward_mm = 0.0;
    double outward_mm = 0.0;
    std::size_t markers = 0;
    for (const char* rib : {"third rib", "fifth rib"}) {
        for (const Facet& marker : markersAt(frontEnd_mm(breath, rib), ribs)) {
            forward_mm -= marker.moved_mm.y();
            upward_mm += marker.moved_mm.z();
            outward_mm += std::copysign(1.0, marker.p_mm.x()) * marker.moved_mm.x();
            ++markers;
        }
    }
    QVERIFY(markers > 50);
    const double count = double(markers);
    qInfo("%.1f mm forward, %.1f mm up, %.1f mm outward", forward_mm / count, upward_mm / count,
          outward_mm / count);
    QVERIFY(forward_mm > 3.0 * count && forward_mm < 5.0 * count);
    QVERIFY(upward_mm > 3.0 * count && upward_mm < 5.0 * count);
    QVERIFY(outward_mm > 1.0 * count && outward_mm < 2.0 * count);
}

CARINA_TEST(TestQuietBreath)

} // namespace carina::quiet_breath_test

#include "tst_quiet_breath.moc"
