#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace carina::builtin_airway_test
{

class TestBuiltinAirway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracheaHasItsLength_data() { patients(); }
    void tracheaHasItsLength();
    void tracheaHasItsDiameters_data() { patients(); }
    void tracheaHasItsDiameters();
    void tracheaHasEighteenRingsAndAFlatBack_data() { patients(); }
    void tracheaHasEighteenRingsAndAFlatBack();
    void tracheaEndsAtTheCarina_data() { patients(); }
    void tracheaEndsAtTheCarina();
    void bronchiLeaveAtTheirAngles_data() { patients(); }
    void bronchiLeaveAtTheirAngles();
    void pathHasTheDistancesOfTheTeethAndCords_data() { patients(); }
    void pathHasTheDistancesOfTheTeethAndCords();
    void pathIsSmoothAndInsideTheTrachea_data() { patients(); }
    void pathIsSmoothAndInsideTheTrachea();

private:
    static void patients();
};

namespace
{

constexpr double kMillimetre = 1e-3;

struct Patient {
    Anatomy anatomy;
    PatientDimensions dimensions;
    Vec3 up; ///< the trachea's axis, from the carina to the cords
};

const TriangleMesh& meshOfRole(const Anatomy& anatomy, PartRole role)
{
    return std::find_if(anatomy.parts.begin(), anatomy.parts.end(),
                        [role](const AnatomyPart& part) { return part.role == role; })
        ->levels[0];
}

Patient make(BuiltinPatient which)
{
    Anatomy anatomy = builtinPatient(which).value();
    const Vec3 up = anatomy.landmarks.p_A_glottis.normalized();
    return {std::move(anatomy), dimensionsOf(which), up};
}

const Patient& patientOf(int which)
{
    static const Patient adult = make(BuiltinPatient::Adult);
    static const Patient child = make(BuiltinPatient::TwelveYears);
    return which == 0 ? adult : child;
}

/// Smallest and largest of the section's outline along a direction.
std::pair<double, double> extent(const test::Section& section, const Vec3& along)
{
    const auto [low, high] = std::minmax_element(
        section.points.begin(), section.points.end(),
        [&](const Vec3& a, const Vec3& b) { return a.dot(along) < b.dot(along); });
    return {low->dot(along), high->dot(along)};
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// Maxima that stand out by more than `height` from the lows on both sides.
int hillsIn(const std::vector<double>& profile, double height)
{
    int hills = 0;
    double low = profile.front();
    double high = profile.front();
    bool rising = true;
    for (const double value : profile) {
        high = std::max(high, value);
        low = std::min(low, value);
        if (rising && value < high - height) {
            ++hills;
            rising = false;
            low = value;
        } else if (!rising && value > low + height) {
            rising = true;
            high = value;
        }
    }
    return hills;
}

/// A profile less its mean over `half` steps to either side, fewer at its ends: the trachea is
/// deeper in its middle.
std::vector<double> withoutSlope(const std::vector<double>& profile, std::size_t half)
{
    std::vector<double> flat;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const std::size_t first = i - std::min(half, i);
        const std::size_t last = std::min(i + half + 1, profile.size());
        const double sum = std::accumulate(profile.begin() + std::ptrdiff_t(first),
                                           profile.begin() + std::ptrdiff_t(last), 0.0);
        flat.push_back(profile[i] - sum / double(last - first));
    }
    return flat;
}

double lengthFrom(const std::vector<Vec3>& path, std::size_t first)
{
    double sum = 0.0;
    for (std::size_t i = first + 1; i < path.size(); ++i)
        sum += (path[i] - path[i - 1]).norm();
    return sum;
}

std::size_t nearestTo(const std::vector<Vec3>& path, const Vec3& p)
{
    return std::size_t(std::min_element(path.begin(), path.end(),
                                        [&p](const Vec3& a, const Vec3& b) {
                                            return (a - p).norm() < (b - p).norm();
                                        })
                       - path.begin());
}

/// Whether a place lies in the air that a tube's wall surrounds at its level.
bool isInLumen(const TriangleMesh& tube, const test::Plane& level)
{
    const test::Section wall = test::sectionOf(tube, level);
    const Vec3 back = level.normal.cross(Vec3::UnitX()).normalized();
    const auto surrounds = [&](const Vec3& along) {
        const auto [least, most] = extent(wall, along);
        return least < level.point.dot(along) && level.point.dot(along) < most;
    };
    return surrounds(Vec3::UnitX()) && surrounds(back)
           && test::windingNumber(tube, level.point) < 0.5;
}

} // namespace

void TestBuiltinAirway::patients()
{
    QTest::addColumn<int>("which");
    QTest::newRow("adult") << 0;
    QTest::newRow("twelve years") << 1;
}

void TestBuiltinAirway::tracheaHasItsLength()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    double top = 0.0;
    for (const Vec3f& p : meshOfRole(patient.anatomy, PartRole::Trachea).positions)
        top = std::max(top, p.cast<double>().dot(patient.up));
    QVERIFY(std::abs(top - patient.dimensions.tracheaLength.si) < 1.0 * kMillimetre);
}

void TestBuiltinAirway::tracheaHasItsDiameters()
{
    QFETCH(int, which);
    constexpr double kTolerance = 0.5 * kMillimetre;
    const Patient& patient = patientOf(which);
    const Vec3 back = patient.up.cross(Vec3::UnitX()).normalized();
    std::vector<double> coronal;
    std::vector<double> sagittal;
    // Above that it narrows towards the cricoid.
    for (double share = 0.3; share < 0.6; share += 0.005) {
        const Vec3 at = share * patient.dimensions.tracheaLength.si * patient.up;
        const test::Section section =
            test::sectionOf(meshOfRole(patient.anatomy, PartRole::Trachea), {at, patient.up});
        const auto [right, left] = extent(section, Vec3::UnitX());
        const auto [front, rear] = extent(section, back);
        coronal.push_back(left - right);
        sagittal.push_back(rear - front);
    }
    QVERIFY(std::abs(median(coronal) - patient.dimensions.tracheaCoronal.si) < kTolerance);
    QVERIFY(std::abs(median(sagittal) - patient.dimensions.tracheaSagittal.si) < kTolerance);
}

void TestBuiltinAirway::tracheaHasEighteenRingsAndAFlatBack()
{
    QFETCH(int, which);
    constexpr double kRingStandsOut = 0.4 * kMillimetre;
    constexpr double kFlat = 0.2 * kMillimetre;
    const Patient& patient = patientOf(which);
    const Vec3 back = patient.up.cross(Vec3::UnitX()).normalized();
    std::vector<double> front;
    std::vector<double> rear;
    for (double along = 0.5 * kMillimetre; along < patient.dimensions.tracheaLength.si;
         along += 0.25 * kMillimetre) {
        const test::Section section = test::sectionOf(
            meshOfRole(patient.anatomy, PartRole::Trachea), {along * patient.up, patient.up});
        if (section.points.empty())
            continue;
        front.push_back(-extent(section, back).first);
        // Between the widening towards the bronchi and the upper end.
        const double share = along / patient.dimensions.tracheaLength.si;
        if (share > 0.32 && share < 0.97)
            rear.push_back(extent(section, back).second);
    }
    constexpr std::size_t kHalfARing = 11; // steps of this profile, in the adult
    front = withoutSlope(front, kHalfARing);
    front.insert(front.begin(), -1.0);
    front.push_back(-1.0);
    QCOMPARE(hillsIn(front, kRingStandsOut), 18);
    const auto [flattest, rearmost] = std::minmax_element(rear.begin(), rear.end());
    QVERIFY2(*rearmost - *flattest < kFlat, qPrintable(QString::number(*rearmost - *flattest)));
}

void TestBuiltinAirway::tracheaEndsAtTheCarina()
{
    QFETCH(int, which);
    constexpr double kVoxel = 1.0 * kMillimetre;
    const Patient& patient = patientOf(which);
    const TriangleMesh& trachea = meshOfRole(patient.anatomy, PartRole::Trachea);
    const auto lowest = std::min_element(
        trachea.positions.begin(), trachea.positions.end(), [&](const Vec3f& a, const Vec3f& b) {
            return a.cast<double>().dot(patient.up) < b.cast<double>().dot(patient.up);
        });
    QVERIFY(std::abs(lowest->cast<double>().dot(patient.up)) < kVoxel);
    QVERIFY(std::abs(double(lowest->x())) < 2.0 * kVoxel);
    QCOMPARE(patient.anatomy.landmarks.p_A_carina, Vec3::Zero().eval());
}

void TestBuiltinAirway::bronchiLeaveAtTheirAngles()
{
    QFETCH(int, which);
    constexpr double kTolerance = 2.0; // degrees
    const Patient& patient = patientOf(which);
    const double size = patient.dimensions.tracheaLength.si / 0.101;
    for (const PartRole role : {PartRole::RightMainBronchus, PartRole::LeftMainBronchus}) {
        const bool right = role == PartRole::RightMainBronchus;
        std::vector<Vec3> centres;
        for (double below = 2.0; below < (right ? 12.0 : 20.0); below += 0.5) {
            const Vec3 at = -below * size * kMillimetre * patient.up;
            centres.push_back(
                test::sectionOf(meshOfRole(patient.anatomy, role), {at, patient.up}).centroid);
        }
        const Vec3 direction = test::directionOf(centres, -patient.up);
        const double angle = inDegrees(radians(std::acos(direction.dot(-patient.up))));
        QVERIFY2(std::abs(angle - (right ? 27.0 : 46.0)) < kTolerance,
                 qPrintable(QString::number(angle)));
        QVERIFY(right ? direction.x() < 0.0 : direction.x() > 0.0);
    }
}

void TestBuiltinAirway::pathHasTheDistancesOfTheTeethAndCords()
{
    QFETCH(int, which);
    constexpr double kTolerance = 0.2 * kMillimetre;
    const Patient& patient = patientOf(which);
    const AirwayLandmarks& landmarks = patient.anatomy.landmarks;
    const std::size_t teeth = nearestTo(landmarks.path_A, landmarks.p_A_incisors);
    const std::size_t cords = nearestTo(landmarks.path_A, landmarks.p_A_glottis);
    QVERIFY((landmarks.path_A[teeth] - landmarks.p_A_incisors).norm() < kTolerance);
    QVERIFY((landmarks.path_A[cords] - landmarks.p_A_glottis).norm() < kTolerance);
    QVERIFY(landmarks.path_A.back().norm() < kTolerance);
    const double teethToCarina = which == 0 ? 0.24013 : 0.232;
    QVERIFY(std::abs(lengthFrom(landmarks.path_A, teeth) - teethToCarina) < kTolerance);
    QVERIFY(std::abs(lengthFrom(landmarks.path_A, cords) - patient.dimensions.cordsToCarina.si)
            < kTolerance);
    QVERIFY(std::abs(lengthFrom(landmarks.path_A, 0) - teethToCarina - 0.1) < kTolerance);
    // The mouth is in front of and above the larynx.
    QVERIFY(landmarks.p_A_incisors.y() < landmarks.p_A_glottis.y() - 0.05);
    QVERIFY(landmarks.p_A_incisors.z() > landmarks.p_A_glottis.z() + 0.03);
}

void TestBuiltinAirway::pathIsSmoothAndInsideTheTrachea()
{
    QFETCH(int, which);
    constexpr double kSharpestTurn = 6.0; // degrees in a step of 2 mm
    const Patient& patient = patientOf(which);
    const std::vector<Vec3>& path = patient.anatomy.landmarks.path_A;
    const TriangleMesh& trachea = meshOfRole(patient.anatomy, PartRole::Trachea);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const Vec3 before = path[i] - path[i - 1];
        const Vec3 after = path[i + 1] - path[i];
        const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
        QVERIFY(inDegrees(radians(turn)) < kSharpestTurn);
        const double along = path[i].dot(patient.up);
        if (along > 2.0 * kMillimetre
            && along < patient.dimensions.tracheaLength.si - 2.0 * kMillimetre)
            QVERIFY(isInLumen(trachea, {path[i], patient.up}));
    }
}

CARINA_TEST(TestBuiltinAirway)

} // namespace carina::builtin_airway_test

#include "tst_builtin_airway.moc"
