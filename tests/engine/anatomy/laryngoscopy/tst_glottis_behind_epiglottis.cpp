#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/larynx/larynx_frame.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/geometry/mesh/surface_query.h"
#include "tests/support/deformed_tissue.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace carina::glottis_behind_epiglottis_test
{
namespace
{

using test::deformed;

/// A patient as made at rest, and the size of the larynx.
struct Person {
    Anatomy anatomy;
    UpperAirway airway;
    ThroatField throat;
    double unit; ///< of LarynxFrame, metres
};

const Person& personCalled(const QString& words)
{
    static std::map<QString, Person> made;
    if (const auto found = made.find(words); found != made.end())
        return found->second;
    const PatientParameters who = patientFromWords(words.toStdString()).value();
    Anatomy anatomy = patientFor(who, Posture::Rest).value();
    const AirwayLandmarks& l = anatomy.landmarks;
    UpperAirway airway = upperAirwayOf(anatomy.parts, l).value();
    const ThroatField throat{l.p_A_carina, l.p_A_glottis, l.p_A_incisors};
    const double unit = LarynxFrame{dimensionsFor(who).value()}.unit();
    return made.emplace(words, Person{std::move(anatomy), std::move(airway), throat, unit})
        .first->second;
}

/// A part of the airway as jaw and blade have moved it.
struct MovedPart {
    std::string name;
    AirwayTissue tissue;
    TriangleMesh mesh;
    Box box;
};

std::vector<MovedPart> movedParts(const Person& person, const LaryngoscopyPose& pose)
{
    std::vector<MovedPart> parts;
    for (const AnatomyPart& part : person.anatomy.parts) {
        const ChestRegion region = regionOf(part);
        const auto follows = tissueOf(region);
        const auto givesWay = airwayTissueOf(region);
        if (!follows || !givesWay)
            continue;
        TriangleMesh mesh =
            deformed(deformed(part.levels.front(), {person.throat, pose.X_AJ}, *follows),
                     pose.field, *givesWay);
        const Box box = boundsOf(mesh);
        parts.push_back({part.name, *givesWay, std::move(mesh), box});
    }
    return parts;
}

/// Whether a ray comes near the middle of a box: so that most parts need not be asked.
bool mayMeet(const Box& box, const Vec3& p_A, const Vec3& direction_A)
{
    const Vec3 to = box.centre() - p_A;
    const Vec3 along = direction_A.normalized();
    return (to - to.dot(along) * along).norm() <= 0.5 * box.size().norm();
}

/// The name of the first part that a ray meets; empty where it meets none.
std::string firstHit(const std::vector<MovedPart>& parts, const Vec3& p_A, const Vec3& direction_A)
{
    std::string first;
    double nearest = 0.0;
    for (const MovedPart& part : parts) {
        if (!mayMeet(part.box, p_A, direction_A))
            continue;
        const auto hit = rayHit(part.mesh, p_A, direction_A);
        if (hit && (first.empty() || *hit < nearest)) {
            first = part.name;
            nearest = *hit;
        }
    }
    return first;
}

bool isInLarynx(const std::string& name)
{
    return name.find("vocal") != std::string::npos || name.find("vestibular") != std::string::npos
           || name.find("arytenoid") != std::string::npos || name == "Trachea"
           || name == "Cricoid cartilage";
}

} // namespace

/// The entrance of the larynx lies behind the epiglottis. The vallecula in front of it is closed by
/// its floor and its glosso-epiglottic folds, and the larynx is so beside the epiglottis, whose
/// edges its wall goes on from (Gray 1918: the quadrangular membrane).
class TestGlottisBehindEpiglottis : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNotSeenPastItsFront_data() { laryngoscopies(); }
    void isNotSeenPastItsFront();
    void hasAFloorBeforeIt_data() { laryngoscopies(); }
    void hasAFloorBeforeIt();

private:
    static void laryngoscopies()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<BladeKind>("kind");
        const auto row = [](const char* words, BladeKind kind) {
            QTest::addRow("%s, %s", words, bladeOf(kind).name.data())
                << QString::fromLatin1(words) << kind;
        };
        row("adult", BladeKind::Macintosh3);
        row("45 years, 165 cm, woman", BladeKind::Macintosh3);
        row("child", BladeKind::Macintosh2);
        row("6 years, 116 cm, boy", BladeKind::Macintosh2);
        row("3 years, 96 cm, boy", BladeKind::Macintosh2);
        row("3 years, 96 cm, boy", BladeKind::Miller1);
        row("1 year, 75 cm, girl", BladeKind::Miller1);
        row("newborn, 50 cm, girl", BladeKind::Miller0);
    }
};

/// Whatever has been lifted: a ray from the camera through a place before the epiglottis, no
/// farther aside than it is wide there, meets it or what closes the vallecula, and nothing that is
/// in the larynx.
void TestGlottisBehindEpiglottis::isNotSeenPastItsFront()
{
    QFETCH(const QString, words);
    QFETCH(const BladeKind, kind);
    const Person& person = personCalled(words);
    const Blade& blade = bladeOf(kind);
    for (const LaryngoscopyStep step : {LaryngoscopyStep::Epiglottis, LaryngoscopyStep::Full}) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift);
        const std::vector<MovedPart> parts = movedParts(person, pose);
        const UpperAirway moved = followed(person.airway, {person.throat, pose.X_AJ});
        const Vec3 p_A_eye = (pose.X_AL * cameraOnBlade(blade)).translation();
        const Vec3 whole = moved.p_A_epiglottisTip - moved.p_A_epiglottisBase;
        for (const double share : {0.3, 0.45, 0.6, 0.75, 0.9}) {
            const Vec3 p_A_leaf = moved.p_A_epiglottisBase + share * whole;
            const Vec3 p_A_lifted = p_A_leaf + larynxTilt<double>(pose.field.frame(), p_A_leaf).d;
            for (double aside = -4.0; aside <= 4.0; aside += 2.0)
                for (const double before : {3.0, 5.0, 8.0}) {
                    const Vec3 p_A = p_A_lifted + person.unit * aside * Vec3::UnitX()
                                     + person.unit * before * moved.forward_A();
                    const std::string seen = firstHit(parts, p_A_eye, p_A - p_A_eye);
                    const std::string where = std::string{stepName(step)} + ": " + seen + " at "
                                              + std::to_string(share) + " of the height, "
                                              + std::to_string(aside) + " aside, "
                                              + std::to_string(before) + " before it";
                    QVERIFY2(!isInLarynx(seen), where.c_str());
                }
        }
    }
}

/// Of what goes with the larynx, a ray straight down before the epiglottis meets the floor of the
/// vallecula or mucosa that leans over it, and no cartilage: also where the tongue has been taken
/// away.
void TestGlottisBehindEpiglottis::hasAFloorBeforeIt()
{
    QFETCH(const QString, words);
    QFETCH(const BladeKind, kind);
    const Person& person = personCalled(words);
    const LaryngoscopyPose pose = laryngoscopyPose(person.airway, person.throat, bladeOf(kind),
                                                   LaryngoscopyStep::Full, kUsualLift);
    std::vector<MovedPart> parts = movedParts(person, pose);
    std::erase_if(parts, [](const MovedPart& part) { return part.tissue != AirwayTissue::Larynx; });
    const UpperAirway moved = followed(person.airway, {person.throat, pose.X_AJ});
    const Vec3 p_A_front =
        moved.p_A_vallecula + larynxTilt<double>(pose.field.frame(), moved.p_A_vallecula).d;
    const double above = 2.0 * (moved.p_A_epiglottisTip - moved.p_A_vallecula).norm();
    for (double aside = -8.0; aside <= 8.0; aside += 1.0)
        for (double before = 2.0; before <= 8.0; before += 1.0) {
            const Vec3 p_A = p_A_front + person.unit * aside * Vec3::UnitX()
                             + person.unit * before * moved.forward_A();
            const std::string seen = firstHit(parts, p_A + above * moved.up_A, -moved.up_A);
            const bool isClosed =
                !seen.empty() && !isInLarynx(seen) && seen.find("cartilage") == std::string::npos;
            const std::string where = (seen.empty() ? "nothing" : seen) + " at "
                                      + std::to_string(aside) + " aside, " + std::to_string(before)
                                      + " before it";
            QVERIFY2(isClosed, where.c_str());
        }
}

CARINA_TEST(TestGlottisBehindEpiglottis)

} // namespace carina::glottis_behind_epiglottis_test

#include "tst_glottis_behind_epiglottis.moc"
