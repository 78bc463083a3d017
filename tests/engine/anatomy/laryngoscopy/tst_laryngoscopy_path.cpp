#include "engine/anatomy/events/airway_changes.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace carina::laryngoscopy_path_test
{
namespace
{

constexpr double kLengthTolerance_m = 1e-4;
/// Length of a man's open glottis (Miller's Anesthesia), and of a boy's of 12 years by its
/// membranous part (11.2 mm, measuring sticks in vivo), which is 60 % of it.
constexpr double kMensGlottis_mm = 23.0;
constexpr double kBoysGlottis_mm = 11.2 / 0.6;
constexpr double kGlottisTolerance_mm = 1.0;

const Anatomy& resting(BuiltinPatient who)
{
    static std::map<BuiltinPatient, Anatomy> made;
    const auto found = made.find(who);
    if (found != made.end())
        return found->second;
    return made.emplace(who, patientFor(parametersOf(who), Posture::Rest).value()).first->second;
}

/// One patient, and how its tissue follows the jaw.
struct Person {
    UpperAirway airway;
    ThroatField throat;
};

Person personOf(BuiltinPatient who)
{
    const Anatomy& anatomy = resting(who);
    const AirwayLandmarks& l = anatomy.landmarks;
    return {upperAirwayOf(anatomy.parts, l).value(), {l.p_A_carina, l.p_A_glottis, l.p_A_incisors}};
}

Vec3 tipOf(const Blade& blade, const LaryngoscopyPose& pose)
{
    return pose.X_AL * middleOfBlade(blade.form, 1.0);
}

/// How far below the blade a place is, from its underside.
double belowBlade(const Blade& blade, const LaryngoscopyPose& pose, const Vec3& p_A)
{
    const Vec3 p_L = pose.X_AL.inverse() * p_A;
    return middleOfBlade(blade.form, -p_L.z() / blade.form.reach).y() - kBladeHalfThickness
           - p_L.y();
}

/// How far forward the free edge of the epiglottis is taken.
double epiglottisForward_mm(const Person& person, const LaryngoscopyPose& pose)
{
    const UpperAirway moved = followed(person.airway, {person.throat, pose.X_AJ});
    const Vec3 d = larynxTilt<double>(pose.field.frame(), moved.p_A_epiglottisTip).d;
    return 1e3 * d.dot(moved.forward_A());
}

} // namespace

/// What is pressed flat keeps a fifth, so some of it stays inside the blade: of a man's tongue the
/// more before an infant's blade. Metres.
double mostInside(BladeKind kind)
{
    const bool isOfInfants = kind == BladeKind::Macintosh0 || kind == BladeKind::Macintosh1
                             || kind == BladeKind::Miller1;
    return isOfInfants ? 2.5e-3 : 1.5e-3;
}

class TestLaryngoscopyPath : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsThePlacesOfAnAirway_data() { people(); }
    void findsThePlacesOfAnAirway();
    void hasAGlottisOfPublishedLength();
    void saysWhatIsMissing();
    void goesInStepByStep_data() { blades(); }
    void goesInStepByStep();
    void goesOnBetweenTheSteps_data() { blades(); }
    void goesOnBetweenTheSteps();
    void keepsClearOfTheTeeth_data() { blades(); }
    void keepsClearOfTheTeeth();
    void keepsClearOfTeethThatStandOut_data() { blades(); }
    void keepsClearOfTeethThatStandOut();
    void opensTheMouthNoFartherThanItLets();
    void liftsTheEpiglottisOnlyInTheEnd_data() { blades(); }
    void liftsTheEpiglottisOnlyInTheEnd();
    void leavesNoTongueDeepInsideTheBlade_data() { blades(); }
    void leavesNoTongueDeepInsideTheBlade();
    void takesAFallenEpiglottisAlongWithAStraightBlade();
    void movesTissueWhereverAJawIs_data() { people(); }
    void movesTissueWhereverAJawIs();
    void goesInThroughAMouthThatHasMoved_data() { blades(); }
    void goesInThroughAMouthThatHasMoved();

private:
    static void people()
    {
        QTest::addColumn<BuiltinPatient>("who");
        QTest::newRow("adult") << BuiltinPatient::Adult;
        QTest::newRow("child") << BuiltinPatient::TwelveYears;
    }
    static void blades()
    {
        QTest::addColumn<BladeKind>("kind");
        for (const BladeKind kind : kBladeKinds)
            QTest::newRow(bladeOf(kind).name.data()) << kind;
    }
};

// From the front to the back, and from the head to the feet.
void TestLaryngoscopyPath::findsThePlacesOfAnAirway()
{
    QFETCH(const BuiltinPatient, who);
    const UpperAirway airway = personOf(who).airway;
    QVERIFY(std::abs(airway.forward_A().dot(airway.up_A)) < 1e-12);
    QVERIFY(airway.forward_A().y() < -0.9);
    QVERIFY(airway.p_A_uvula.y() > airway.p_A_incisors.y() + 0.04);
    QVERIFY(airway.p_A_epiglottisTip.z() < airway.p_A_uvula.z());
    QVERIFY(airway.p_A_epiglottisTip.z() > airway.p_A_vallecula.z());
    QVERIFY(airway.p_A_vallecula.z() > airway.p_A_epiglottisBase.z());
    QVERIFY(airway.p_A_epiglottisBase.z() > airway.p_A_commissure.z());
    QVERIFY(airway.forward_A().dot(airway.p_A_commissure - airway.p_A_notch) > 0.01);
    QVERIFY((airway.path_A.front() - airway.p_A_incisors).norm() < kLengthTolerance_m);
    // Its trachea has the diameters of the patient (docs/patient.md), and the skin is before it.
    QVERIFY(airway.windpipe && airway.p_A_neck && airway.hasIncisors);
    QVERIFY(airway.windpipe->halfWidth > millimetres(5.0)
            && airway.windpipe->halfWidth < millimetres(12.0));
    QVERIFY(airway.windpipe->halfDepth > millimetres(5.0)
            && airway.windpipe->halfDepth < millimetres(10.0));
    QVERIFY(std::abs(airway.windpipe->p_A_middle.x()) < 1e-3);
    const Vec3 toSkin = *airway.p_A_neck - airway.windpipe->p_A_middle;
    QVERIFY(toSkin.dot(airway.forward_A()) > 0.02 && std::abs(toSkin.dot(airway.up_A)) < 0.01);
    QCOMPARE(airway.p_A_edge(), airway.p_A_incisors);
    QVERIFY(!airway.mostOpening);
}

void TestLaryngoscopyPath::hasAGlottisOfPublishedLength()
{
    const double man_mm = inMillimetres(personOf(BuiltinPatient::Adult).airway.glottis());
    const double boy_mm = inMillimetres(personOf(BuiltinPatient::TwelveYears).airway.glottis());
    qInfo("glottis %.1f mm in the man, %.1f mm in the boy", man_mm, boy_mm);
    QVERIFY(std::abs(man_mm - kMensGlottis_mm) < kGlottisTolerance_mm);
    QVERIFY(std::abs(boy_mm - kBoysGlottis_mm) < kGlottisTolerance_mm);
}

void TestLaryngoscopyPath::saysWhatIsMissing()
{
    const Anatomy& whole = resting(BuiltinPatient::Adult);
    for (const auto& [words, missing] :
         {std::pair{"Epiglottis", "no epiglottis"}, std::pair{"vocal", "no vocal cords"},
          std::pair{"Soft palate", "no soft palate"}}) {
        std::vector<AnatomyPart> parts = whole.parts;
        std::erase_if(parts, [words = words, missing = missing](const AnatomyPart& part) {
            return part.name.find(words) != std::string::npos
                   || (missing == std::string{"no soft palate"} && part.name == "Uvula");
        });
        const auto found = upperAirwayOf(parts, whole.landmarks);
        QVERIFY(!found.has_value());
        QCOMPARE(found.error().code, Errc::NoAirway);
        QCOMPARE(found.error().detail, std::string{missing});
    }
}

void TestLaryngoscopyPath::goesInStepByStep()
{
    QFETCH(const BladeKind, kind);
    const Blade& blade = bladeOf(kind);
    const Person person = personOf(BuiltinPatient::Adult);
    double left = 1.0; // metres to the glottis
    for (const LaryngoscopyStep step : kLaryngoscopySteps) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift);
        const Vec3 tip = tipOf(blade, pose);
        QVERIFY(std::abs(tip.x()) < kLengthTolerance_m);
        QVERIFY(pose.X_AL.rotation().toRotationMatrix().col(0).isApprox(-Vec3::UnitX()));
        if (step == LaryngoscopyStep::Full)
            break;
        const double toGlottis = (tip - person.airway.p_A_notch).norm();
        QVERIFY2(toGlottis < left, stepName(step));
        left = toGlottis;
    }
}

// Through each step, and from one to the next without a jump: from teeth to vallecula a tip moves
// some 100 mm, of which a hundredth of a step has a small part.
void TestLaryngoscopyPath::goesOnBetweenTheSteps()
{
    constexpr double kSame = 1e-12;
    constexpr double kMostMove_m = 2e-3;
    constexpr int kPerStep = 100;
    QFETCH(const BladeKind, kind);
    const Blade& blade = bladeOf(kind);
    const Person person = personOf(BuiltinPatient::Adult);
    const auto poseAt = [&](auto where) {
        return laryngoscopyPose(person.airway, person.throat, blade, where, kUsualLift);
    };
    for (const LaryngoscopyStep step : kLaryngoscopySteps)
        QVERIFY((poseAt(double(step)).X_AL.matrix() - poseAt(step).X_AL.matrix()).norm() < kSame);
    Vec3 last = tipOf(blade, poseAt(0.0));
    for (int i = 1; i <= kPerStep * int(LaryngoscopyStep::Full); ++i) {
        const LaryngoscopyPose pose = poseAt(double(i) / kPerStep);
        const Vec3 tip = tipOf(blade, pose);
        QVERIFY2((tip - last).norm() < kMostMove_m, qPrintable(QString::number(i)));
        last = tip;
    }
    QCOMPARE(poseAt(7.0).lift, kUsualLift);
}

void TestLaryngoscopyPath::keepsClearOfTheTeeth()
{
    QFETCH(const BladeKind, kind);
    const Blade& blade = bladeOf(kind);
    for (const BuiltinPatient who : {BuiltinPatient::Adult, BuiltinPatient::TwelveYears}) {
        const Person person = personOf(who);
        for (const LaryngoscopyStep step : kLaryngoscopySteps) {
            if (step == LaryngoscopyStep::Teeth)
                continue; // the tip itself is there
            const LaryngoscopyPose pose =
                laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift);
            const double clear = belowBlade(blade, pose, person.airway.p_A_incisors);
            if (kind == BladeKind::Hyperangulated && who == BuiltinPatient::TwelveYears
                && step == LaryngoscopyStep::Uvula)
                QEXPECT_FAIL("", "an adult's blade of this curve reaches a child's teeth there",
                             Continue);
            QVERIFY2(clear > kTeethClearance.si - kLengthTolerance_m, stepName(step));
        }
    }
}

// The more they stand out and down, the less room a blade has, and so it is turned.
void TestLaryngoscopyPath::keepsClearOfTeethThatStandOut()
{
    QFETCH(const BladeKind, kind);
    const Blade& blade = bladeOf(kind);
    const Person person = personOf(BuiltinPatient::Adult);
    UpperAirway prominent = person.airway;
    prominent.d_A_incisors = {0.0, -0.006, -0.002};
    for (const LaryngoscopyStep step :
         {LaryngoscopyStep::Epiglottis, LaryngoscopyStep::Partial, LaryngoscopyStep::Full}) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(prominent, person.throat, blade, step, kUsualLift);
        const double clear = belowBlade(blade, pose, prominent.p_A_edge());
        QVERIFY2(clear > kTeethClearance.si - kLengthTolerance_m, stepName(step));
        const LaryngoscopyPose usual =
            laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift);
        QVERIFY((tipOf(blade, pose) - tipOf(blade, usual)).norm() < kLengthTolerance_m);
        QVERIFY(pose.X_AL.rotation().angularDistance(usual.X_AL.rotation()) > 1e-3);
    }
}

void TestLaryngoscopyPath::opensTheMouthNoFartherThanItLets()
{
    const Person person = personOf(BuiltinPatient::Adult);
    UpperAirway stiff = person.airway;
    const auto opening_mm = [&](const UpperAirway& airway) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(airway, person.throat, bladeOf(BladeKind::Macintosh3),
                             LaryngoscopyStep::Epiglottis, kUsualLift);
        return 1e3 * (pose.X_AJ * airway.p_A_incisors - airway.p_A_incisors).norm();
    };
    QVERIFY(opening_mm(stiff) > 30.0);
    stiff.mostOpening = millimetres(15.0);
    QVERIFY2(std::abs(opening_mm(stiff) - 15.0) < 0.1,
             qPrintable(QString::number(opening_mm(stiff))));
    stiff.mostOpening = millimetres(60.0);
    QVERIFY(opening_mm(stiff) > 30.0);
}

void TestLaryngoscopyPath::liftsTheEpiglottisOnlyInTheEnd()
{
    constexpr double kLeastLifted_mm = 10.0;
    QFETCH(const BladeKind, kind);
    const Person person = personOf(BuiltinPatient::Adult);
    double last_mm = 0.0;
    for (const LaryngoscopyStep step : kLaryngoscopySteps) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(person.airway, person.throat, bladeOf(kind), step, kUsualLift);
        const double forward_mm = epiglottisForward_mm(person, pose);
        QVERIFY2(forward_mm >= last_mm, stepName(step));
        if (step == LaryngoscopyStep::Epiglottis)
            QVERIFY(forward_mm < 1.0);
        last_mm = forward_mm;
    }
    QVERIFY2(last_mm > kLeastLifted_mm, qPrintable(QString::number(last_mm)));
}

void TestLaryngoscopyPath::leavesNoTongueDeepInsideTheBlade()
{
    QFETCH(const BladeKind, kind);
    if (kind == BladeKind::Miller0)
        QSKIP("a newborn's blade pushes aside 25 mm, and a man's tongue is thicker");
    const Blade& blade = bladeOf(kind);
    const Person person = personOf(BuiltinPatient::Adult);
    const auto& parts = resting(BuiltinPatient::Adult).parts;
    const auto tongue = std::ranges::find(parts, PartRole::Tongue, &AnatomyPart::role);
    for (const LaryngoscopyStep step : kLaryngoscopySteps) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift);
        const TriangleMesh moved = deformed(
            deformed(tongue->levels.front(), {person.throat, pose.X_AJ}, ThroatTissue::Airway),
            pose.field, AirwayTissue::Throat);
        for (const Vec3f& p : moved.positions) {
            const Vec3 p_L = pose.X_AL.inverse() * p.cast<double>();
            const double share = -p_L.z() / blade.form.reach;
            if (std::abs(p_L.x()) > 0.5 * blade.form.width || share < 0.0 || share > 1.0)
                continue;
            const double above = p_L.y() - middleOfBlade(blade.form, share).y();
            QVERIFY2(above > kBladeHalfThickness - mostInside(kind), stepName(step));
        }
    }
}

/// Its tip comes forward by what it had fallen back, or more.
void TestLaryngoscopyPath::takesAFallenEpiglottisAlongWithAStraightBlade()
{
    const Person person = personOf(BuiltinPatient::Adult);
    const UpperAirway fallen = changed(
        person.airway, airwayChanges(person.airway, {{AirwayEventKind::FloppyEpiglottis, 1.0}}));
    const Vec3 forward_A = person.airway.forward_A();
    const double back_m = forward_A.dot(person.airway.p_A_epiglottisTip - fallen.p_A_epiglottisTip);
    const auto taken_m = [&](BladeKind kind) {
        const LaryngoscopyPose pose = laryngoscopyPose(fallen, person.throat, bladeOf(kind),
                                                       LaryngoscopyStep::Full, kUsualLift);
        const Vec3 p_A_tip =
            followed(fallen, FollowingThroat{person.throat, pose.X_AJ}).p_A_epiglottisTip;
        return forward_A.dot(larynxTilt<double>(pose.field.frame(), p_A_tip).d);
    };
    QVERIFY(back_m > 0.01);
    QVERIFY2(taken_m(BladeKind::Miller2) > back_m,
             qPrintable(QString::number(taken_m(BladeKind::Miller2))));
}

// As far away and as much turned as other programs can say, and farther than any is drawn.
void TestLaryngoscopyPath::movesTissueWhereverAJawIs()
{
    constexpr double kWay_m = 0.5;
    constexpr int kJaws = 300;
    QFETCH(const BuiltinPatient, who);
    const Person person = personOf(who);
    std::mt19937 random{24};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    const auto vector = [&] { return Vec3{share(random), share(random), share(random)}; };
    std::vector<RigidTransform> jaws{RigidTransform::translation(-kWay_m * Vec3::UnitZ())};
    while (jaws.size() < kJaws)
        jaws.push_back({rotationFromVector(std::numbers::pi * vector()), kWay_m * vector()});
    for (const RigidTransform& X_AJ : jaws) {
        const UpperAirway moved = followed(person.airway, {person.throat, X_AJ});
        for (const BladeKind kind : {BladeKind::Macintosh3, BladeKind::Miller2}) {
            const Vec3 p_A_blade = moved.p_A_vallecula + 0.03 * vector();
            const RigidTransform X_AL{rotationFromVector(vector()), p_A_blade};
            const auto frame = bladeInTissue(moved, bladeOf(kind), X_AL).frame();
            QVERIFY(frame.tilt.norm() * frame.back.norm() < 30.0);
            const auto pull = larynxTilt<double>(frame, moved.p_A_epiglottisTip);
            QVERIFY(pull.d.allFinite() && pull.gradient.allFinite());
            QVERIFY((Mat3::Identity() + pull.gradient).determinant() > 1.0 - 1e-9);
        }
    }
}

// Past the teeth as they lie, into the vallecula as it lies, and no tongue stays in the blade.
void TestLaryngoscopyPath::goesInThroughAMouthThatHasMoved()
{
    constexpr double kNearVallecula_m = 12e-3; // 4 mm in front of it; a straight blade behind
    QFETCH(const BladeKind, kind);
    if (kind == BladeKind::Miller0)
        QSKIP("a newborn's blade pushes aside 25 mm, and a man's tongue is thicker");
    const Blade& blade = bladeOf(kind);
    const Person person = personOf(BuiltinPatient::Adult);
    const AirwayLandmarks& marks = resting(BuiltinPatient::Adult).landmarks;
    const auto& parts = resting(BuiltinPatient::Adult).parts;
    const auto tongue = std::ranges::find(parts, PartRole::Tongue, &AnatomyPart::role);
    for (const HeadPosition& position : {kHeadExtended, kSniffing}) {
        const NeckField neck{marks.p_A_glottis, marks.p_A_incisors, position};
        for (const LaryngoscopyStep step : kLaryngoscopySteps) {
            const LaryngoscopyPose pose =
                laryngoscopyPose(person.airway, person.throat, blade, step, kUsualLift, {}, neck);
            const FollowingThroat throat{person.throat, pose.X_AJ, neck};
            const UpperAirway moved = followed(person.airway, throat);
            QVERIFY(std::abs(moved.size() / person.airway.size() - 1.0) < 0.2);
            QVERIFY((moved.p_A_incisors - neck.X_AU() * person.airway.p_A_incisors).norm()
                    < kLengthTolerance_m);
            if (step != LaryngoscopyStep::Teeth)
                QVERIFY2(belowBlade(blade, pose, moved.p_A_incisors)
                             > kTeethClearance.si - kLengthTolerance_m,
                         stepName(step));
            const double lifted = pose.lift.si;
            const double toVallecula = (tipOf(blade, pose) - moved.p_A_vallecula).norm();
            if (step == LaryngoscopyStep::Full)
                QVERIFY2(toVallecula < lifted + kNearVallecula_m,
                         qPrintable(QString::number(1e3 * toVallecula)));
            const TriangleMesh drawn = deformed(
                deformed(deformed(tongue->levels.front(), neck), throat, ThroatTissue::Airway),
                pose.field, AirwayTissue::Throat);
            for (const Vec3f& p : drawn.positions) {
                const Vec3 p_L = pose.X_AL.inverse() * p.cast<double>();
                const double share = -p_L.z() / blade.form.reach;
                if (std::abs(p_L.x()) > 0.5 * blade.form.width || share < 0.0 || share > 1.0)
                    continue;
                QVERIFY2(p_L.y() - middleOfBlade(blade.form, share).y()
                             > kBladeHalfThickness - mostInside(kind),
                         stepName(step));
            }
        }
    }
}

CARINA_TEST(TestLaryngoscopyPath)

} // namespace carina::laryngoscopy_path_test

#include "tst_laryngoscopy_path.moc"
