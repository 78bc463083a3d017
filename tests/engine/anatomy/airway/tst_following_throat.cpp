#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/role_recognition.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/mesh/plain_obj.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"
#include "tests/support/throat_motion.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace carina::following_throat_test
{

namespace following_throat
{

constexpr double kLeastDeterminant = 0.2;
constexpr double kTouching_m = 2e-3;

constexpr double kWidest_deg = 30.0;
constexpr double kUsual_deg = 18.0;

/// One patient, and how far its surfaces have the mouth open.
struct Person {
    std::vector<AnatomyPart> parts;
    AirwayLandmarks landmarks;
    double held_deg = 0.0;
    double perMillimetre = 1e-3; ///< of a man of 173 cm
};

/// The man whose surfaces are published (BodyParts3D), from the jaw to the carina.
std::optional<Person> realMan()
{
    const auto folder = test::testData("anatomy/bodyparts3d");
    if (!folder)
        return std::nullopt;
    Person man;
    std::ifstream manifest{*folder / "MANIFEST.tsv"};
    for (std::string line; std::getline(manifest, line);) {
        std::istringstream fields{line};
        std::string group;
        std::string file;
        std::string conceptId;
        std::string name;
        std::getline(fields, group, '\t');
        std::getline(fields, file, '\t');
        std::getline(fields, conceptId, '\t');
        std::getline(fields, name, '\t');
        const bool isThroat = group == "larynx" || group == "mouth_pharynx"
                              || group == "neck_muscle" || name == "Trachea" || name == "Mandible"
                              || name == "Left main bronchus"
                              || name == "Right main bronchus proper";
        if (isThroat)
            man.parts.push_back({name,
                                 recogniseRole(conceptId, name),
                                 {},
                                 {test::plainObj(*folder / group / file)}});
    }
    man.landmarks = findAirway(man.parts).value();
    return man;
}

/// In degrees.
double openingOf(const RigidTransform& X_AJ)
{
    const Quat& q = X_AJ.rotation();
    return inDegrees({2.0 * std::atan2(q.vec().norm(), std::abs(q.w()))});
}

std::optional<Person> personCalled(const QString& name)
{
    if (name == QStringLiteral("a real man"))
        return realMan();
    const bool isChild = name == QStringLiteral("the child");
    const bool isHeldOpen = name == QStringLiteral("the adult, held open");
    const PatientParameters who =
        parametersOf(isChild ? BuiltinPatient::TwelveYears : BuiltinPatient::Adult);
    Anatomy made = patientFor(who, isHeldOpen ? Posture::Laryngoscopy : Posture::Rest).value();
    const double held_deg = isHeldOpen ? openingOf(heldJaw(made.contentHash)) : 0.0;
    return Person{std::move(made.parts), made.landmarks, held_deg, isChild ? 0.9e-3 : 1e-3};
}

/// Of a jaw that opens from being shut, from where the surfaces have it.
RigidTransform jawOf(const Person& person, double opening_deg, double forward_mm)
{
    const Vec3 hinge = person.landmarks.p_A_incisors + person.perMillimetre * Vec3{0.0, 87.0, 45.0};
    const Angle turn = degrees(opening_deg - person.held_deg);
    return RigidTransform::translation(hinge - 1e-3 * forward_mm * Vec3::UnitY())
           * RigidTransform{rotationFromVector(turn.si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-hinge);
}

std::vector<RigidTransform> motionsOf(const Person& person)
{
    std::vector<RigidTransform> motions;
    for (const double share : {0.0, 0.5, 1.0})
        for (const double forward : {0.0, 7.5, 15.0})
            motions.push_back(jawOf(person, share * kWidest_deg, forward));
    return motions;
}

ThroatField throatOf(const Person& person)
{
    return {person.landmarks.p_A_carina, person.landmarks.p_A_glottis,
            person.landmarks.p_A_incisors};
}

/// Calls f(p, tissue, name) for vertices of what follows the jaw.
template <class F> void forVertices(const Person& person, F f)
{
    for (const AnatomyPart& part : person.parts) {
        const auto tissue = tissueOf(regionOf(part));
        if (!tissue)
            continue;
        for (std::size_t i = 0; i < part.levels.front().positions.size(); i += 3)
            f(Vec3{part.levels.front().positions[i].cast<double>()}, *tissue, part.name);
    }
}

/// The surfaces for which `is` holds, as one.
template <class Is> SurfaceTree surfaceOf(const Person& person, Is is)
{
    TriangleMesh all;
    for (const AnatomyPart& part : person.parts) {
        if (!is(part))
            continue;
        const TriangleMesh& mesh = part.levels.front();
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const Triangle& t : mesh.triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return SurfaceTree{all};
}

/// The largest of a measure, and where.
struct Largest {
    double value = 0.0;
    std::string where;

    void take(double v, const std::string& place)
    {
        if (v > value) {
            value = v;
            where = place;
        }
    }
};

} // namespace following_throat

using namespace following_throat;

/// The throat of whole patients, as the jaw moves.
class TestFollowingThroat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void foldsNowhere_data() { people(); }
    void foldsNowhere();
    void staysOnTheJaw_data() { people(); }
    void staysOnTheJaw();
    void staysTogether_data() { people(); }
    void staysTogether();

private:
    static void people()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"the adult", "the adult, held open", "the child", "a real man"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    const Person* person(const QString& name)
    {
        auto found = m_people.find(name);
        if (found == m_people.end())
            found = m_people.emplace(name, personCalled(name)).first;
        return found->second ? &*found->second : nullptr;
    }

    std::map<QString, std::optional<Person>> m_people;
};

void TestFollowingThroat::foldsNowhere()
{
    QFETCH(QString, name);
    const Person* somebody = person(name);
    if (somebody == nullptr)
        QSKIP("the real man is not here");
    const ThroatField throat = throatOf(*somebody);
    double least = 1.0;
    std::string where;
    for (const RigidTransform& X_AJ : motionsOf(*somebody))
        forVertices(*somebody, [&](const Vec3& p_A, ThroatTissue tissue, const std::string& part) {
            const Mat3 j = Mat3::Identity() + test::throatAt(throat, p_A, X_AJ, tissue).gradient;
            if (j.determinant() < least) {
                least = j.determinant();
                where = part;
            }
        });
    qInfo("least determinant %.2f, %s", least, where.c_str());
    QVERIFY(least > kLeastDeterminant);
}

// Opened by 18 degrees, to 30 mm, or brought forward by 10 mm, the tongue and the floor of the
// mouth leave the bone they touch by less than that; of a mouth that was held open and shuts, by
// twice as much. Where nothing moves they stay.
void TestFollowingThroat::staysOnTheJaw()
{
    QFETCH(QString, name);
    const Person* somebody = person(name);
    if (somebody == nullptr)
        QSKIP("the real man is not here");
    const double gap_mm = somebody->held_deg > 0.0 ? 12.0 : 6.0;
    const ThroatField throat = throatOf(*somebody);
    const SurfaceTree bone = surfaceOf(
        *somebody, [](const AnatomyPart& part) { return part.role == PartRole::Mandible; });
    struct Motion {
        double opening_deg;
        double forward_mm;
        Largest apart_mm{};
    };
    std::array<Motion, 3> motions{{{kUsual_deg, 0.0}, {0.0, 10.0}, {0.0, 0.0}}};
    int touching = 0;
    for (const AnatomyPart& part : somebody->parts) {
        if (part.role != PartRole::Tongue && part.name.find("hyoid") == std::string::npos)
            continue;
        for (const Vec3f& p : part.levels.front().positions) {
            const Vec3 p_A = p.cast<double>();
            if (bone.distanceTo(p_A) > kTouching_m)
                continue;
            ++touching;
            for (Motion& motion : motions) {
                const RigidTransform X_AJ = jawOf(*somebody, motion.opening_deg, motion.forward_mm);
                const Vec3 x_A = p_A + test::throatAt(throat, p_A, X_AJ, ThroatTissue::Airway).d_A;
                motion.apart_mm.take(1e3 * (x_A - X_AJ * p_A).norm(), part.name);
            }
        }
    }
    const Largest& largest_mm = std::ranges::max(motions, {}, [](const Motion& motion) {
                                    return motion.apart_mm.value;
                                }).apart_mm;
    qInfo("%d vertices, at most %.1f mm, %s", touching, largest_mm.value, largest_mm.where.c_str());
    qInfo(
        "made with the mouth open by %.1f degrees; opened to 18 degrees %.1f mm, forward %.1f mm, "
        "shut %.1f mm",
        somebody->held_deg, motions[0].apart_mm.value, motions[1].apart_mm.value,
        motions[2].apart_mm.value);
    QEXPECT_FAIL("the adult, held open",
                 "the root of the tongue leaves the jaw by 12.7 mm where that is 10 mm forward",
                 Continue);
    QVERIFY(largest_mm.value < gap_mm);
}

// Where the pharynx touches what is of the other tissue, one slides along the other.
void TestFollowingThroat::staysTogether()
{
    constexpr double kSlide_mm = 5.0;
    QFETCH(QString, name);
    const Person* somebody = person(name);
    if (somebody == nullptr)
        QSKIP("the real man is not here");
    const ThroatField throat = throatOf(*somebody);
    const SurfaceTree larynx = surfaceOf(*somebody, [](const AnatomyPart& part) {
        return part.role == PartRole::Larynx || part.role == PartRole::Hyoid;
    });
    Largest slide_mm;
    forVertices(*somebody, [&](const Vec3& p_A, ThroatTissue tissue, const std::string& part) {
        if (tissue != ThroatTissue::Pharynx || larynx.distanceTo(p_A) > kTouching_m)
            return;
        for (const RigidTransform& X_AJ :
             {jawOf(*somebody, kUsual_deg, 0.0), jawOf(*somebody, 0.0, 10.0)}) {
            const Vec3 apart = test::throatAt(throat, p_A, X_AJ, ThroatTissue::Pharynx).d_A
                               - test::throatAt(throat, p_A, X_AJ, ThroatTissue::Airway).d_A;
            slide_mm.take(1e3 * apart.norm(), part);
        }
    });
    qInfo("at most %.1f mm, %s", slide_mm.value, slide_mm.where.c_str());
    QVERIFY(slide_mm.value < kSlide_mm);
}

CARINA_TEST(TestFollowingThroat)

} // namespace carina::following_throat_test

#include "tst_following_throat.moc"
