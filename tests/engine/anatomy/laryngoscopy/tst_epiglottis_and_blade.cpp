#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace carina::epiglottis_and_blade_test
{
namespace
{

constexpr double kTouching_mm = 0.5;

/// A patient as made at rest.
struct Person {
    TriangleMesh epiglottis;
    UpperAirway airway;
    ThroatField throat;
};

const Person& personCalled(const QString& words)
{
    static std::map<QString, Person> made;
    if (const auto found = made.find(words); found != made.end())
        return found->second;
    const PatientParameters who = patientFromWords(words.toStdString()).value();
    const Anatomy anatomy = patientFor(who, Posture::Rest).value();
    const AirwayLandmarks& l = anatomy.landmarks;
    const auto leaf = std::ranges::find(anatomy.parts, PartRole::Epiglottis, &AnatomyPart::role);
    return made
        .emplace(words, Person{leaf->levels.front(),
                               upperAirwayOf(anatomy.parts, l).value(),
                               {l.p_A_carina, l.p_A_glottis, l.p_A_incisors}})
        .first->second;
}

/// The epiglottis as jaw and blade have moved it, in L.
std::vector<Vec3> movedEpiglottis(const Person& person, const LaryngoscopyPose& pose)
{
    const TriangleMesh moved =
        deformed(deformed(person.epiglottis, {person.throat, pose.X_AJ}, ThroatTissue::Airway),
                 pose.field, AirwayTissue::Larynx);
    const RigidTransform X_LA = pose.X_AL.inverse();
    std::vector<Vec3> places;
    for (const Vec3f& p_A : moved.positions)
        places.push_back(X_LA * p_A.cast<double>());
    return places;
}

/// How far a place lies above the underside of a blade, from heel to tip and between its edges; the
/// least of this and of the ways out past an edge and past the tip, metres.
double throughUnderside(const BladeForm& form, const Vec3& p_L)
{
    const double fromTip = form.reach + p_L.z();
    const double fromEdge = 0.5 * form.width - std::abs(p_L.x());
    if (p_L.z() > 0.0 || fromTip < 0.0 || fromEdge < 0.0)
        return 0.0;
    return std::max(0.0, std::min({-belowUnderside(form, p_L).si, fromTip, fromEdge}));
}

} // namespace

class TestEpiglottisAndBlade : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hangsBehindABladeInTheVallecula_data();
    void hangsBehindABladeInTheVallecula();
};

void TestEpiglottisAndBlade::hangsBehindABladeInTheVallecula_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<BladeKind>("kind");
    const auto row = [](const char* words, BladeKind kind) {
        QTest::addRow("%s, %s", words, bladeOf(kind).name.data())
            << QString::fromLatin1(words) << kind;
    };
    row("adult", BladeKind::Macintosh3);
    row("adult", BladeKind::Hyperangulated);
    row("child", BladeKind::Macintosh2);
    row("1 year, 75 cm, girl", BladeKind::Macintosh1);
    row("newborn, 50 cm, girl", BladeKind::Macintosh0);
}

/// Its tip is in front of the leaf, which in no step is inside the blade, and none of which has
/// passed through it: also where nothing is lifted, or more than usual.
void TestEpiglottisAndBlade::hangsBehindABladeInTheVallecula()
{
    QFETCH(const QString, words);
    QFETCH(const BladeKind, kind);
    const Person& person = personCalled(words);
    const Blade& blade = bladeOf(kind);
    double most_mm = 0.0;
    for (const Length lift : {kUsualLift, millimetres(0.0), millimetres(30.0)})
        for (double progress = 0.0; progress <= double(LaryngoscopyStep::Full); progress += 0.5) {
            const LaryngoscopyPose pose =
                laryngoscopyPose(person.airway, person.throat, blade, progress, lift);
            double deepest_mm = 0.0;
            for (const Vec3& p_L : movedEpiglottis(person, pose))
                deepest_mm = std::max(deepest_mm, 1e3 * throughUnderside(blade.form, p_L));
            const QString where = QStringLiteral("lifted by %1 mm, step %2: %3 mm")
                                      .arg(inMillimetres(lift))
                                      .arg(progress)
                                      .arg(deepest_mm);
            QVERIFY2(deepest_mm < kTouching_mm, qPrintable(where));
            most_mm = std::max(most_mm, deepest_mm);
        }
    qInfo("at most %.2f mm", most_mm);
}

CARINA_TEST(TestEpiglottisAndBlade)

} // namespace carina::epiglottis_and_blade_test

#include "tst_epiglottis_and_blade.moc"
