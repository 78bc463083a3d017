#include "engine/io/site/site_file.h"
#include "tests/support/test_class.h"
#include "tests/ui/registration/registration_desk.h"
#include "widgets/scene/view/graphics.h"

#include <QLineEdit>

namespace carina::whole_registration_test
{
namespace
{

constexpr Length kNoise = millimetres(0.35); // of each sample
constexpr Length kHand = millimetres(1.0);   // of each touch from its place
constexpr double kLargest_mm = 3.0;          // at what counts in the airway
constexpr int kAWhile = 25;                  // samples: too short to be taken for a touch

/// A technician with a hand that strays, before a tracker that is not exact.
struct Technician : RegistrationDesk {
    explicit Technician(unsigned seed)
    {
        site.m_random.seed(seed);
        site.m_noise = kNoise;
        site.m_hand = kHand;
    }

    /// The stylus as it is held at the n-th place: never twice alike.
    [[nodiscard]] static Quat heldAt(int n)
    {
        return rotationFromVector({0.3 * std::sin(1.7 * n), 0.2 * std::cos(2.3 * n), 0.1 * n});
    }
    void holdAt(const Vec3& p_AQ, int samples)
    {
        site.holdFor(*model, samples, site.X_TA * p_AQ, heldAt(held++));
    }
    /// Each place is held for a moment, and taken by a key.
    void touchByKeys()
    {
        for (const Landmark& landmark : site.landmarks()) {
            holdAt(landmark.p_AQ, kAWhile);
            press(Qt::Key_PageDown);
        }
    }
    void verifyByKeys()
    {
        for (const CheckPoint& point : model->verifying().points()) {
            holdAt(point.p_AQ, kAWhile);
            press(Qt::Key_PageDown);
        }
    }
    [[nodiscard]] double error_mm(const Site& kept, const Vec3& p_AQ) const
    {
        return 1e3 * (kept.registration->X_AT * (site.X_TA * p_AQ) - p_AQ).norm();
    }

    int held = 0;
};

/// The file has it all, and the truth is within what was predicted.
void isRegistered(const Technician& technician)
{
    const auto kept = readSiteFile(technician.site.file());
    QVERIFY(kept && kept->registration && kept->verification);
    QCOMPARE(kept->verification->verdict, Verdict::Good);
    QCOMPARE(kept->verification->points.size(), std::size_t{3});
    QVERIFY(!kept->registration->stale && !kept->verification->stale);
    const AirwayLandmarks& airway = technician.site.patient().landmarks();
    const std::vector<ExpectedError> expected = technician.model->fitting().expected();
    const std::array targets{airway.p_A_glottis, airway.p_A_carina, airway.p_A_incisors};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double error = technician.error_mm(*kept, targets[i]);
        qInfo("%-10s off by %.2f mm, 95 %% below %.2f mm", qPrintable(expected[i].name), error,
              expected[i].bound_mm);
        QVERIFY(error < expected[i].bound_mm);
        QVERIFY(error < kLargest_mm);
    }
}

} // namespace

/// From an empty site to a verified one in the real window, in virtual time.
class TestWholeRegistration : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void isDoneByTheMouse_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U})
            QTest::addRow("technician %u", seed) << seed;
    }

    void isDoneByTheMouse()
    {
        QFETCH(unsigned, seed);
        Technician technician{seed};
        RegistrationModel& model = *technician.model;
        QVERIFY(technician.click("primary")); // use the tracker
        technician.site.swing(model);
        QVERIFY(technician.click("next"));
        QVERIFY(technician.click("primary")); // use the landmarks
        for (const Landmark& landmark : technician.site.landmarks())
            technician.holdAt(landmark.p_AQ, 70);
        QVERIFY(technician.click("next"));
        QVERIFY(technician.click("primary")); // fit
        QVERIFY(technician.click("next"));
        for (const CheckPoint& point : model.verifying().points())
            technician.holdAt(point.p_AQ, 70);
        QVERIFY(technician.click("primary")); // record
        isRegistered(technician);
        QVERIFY(technician.click("next"));
        QVERIFY(technician.click("primary")); // finish
        QVERIFY(!technician.window->isVisible());
    }

    void isDoneByKeysAlone()
    {
        Technician technician{4};
        RegistrationModel& model = *technician.model;
        technician.press(Qt::Key_1, Qt::AltModifier);
        QTRY_COMPARE(model.step(), SiteStep::Overview);
        QVERIFY(technician.tabTo("operator"));
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("A. Frei"));
        technician.press(Qt::Key_Tab);
        QCOMPARE(model.site().operatorName, std::string{"A. Frei"});
        technician.press(Qt::Key_Return); // go on: tracker
        QCOMPARE(model.step(), SiteStep::Tracker);
        technician.press(Qt::Key_Return);
        technician.site.swing(model);
        technician.press(Qt::Key_Return); // next
        QCOMPARE(model.step(), SiteStep::Landmarks);
        technician.press(Qt::Key_Return); // use these
        QCOMPARE(model.step(), SiteStep::Touch);
        technician.touchByKeys();
        technician.press(Qt::Key_6, Qt::AltModifier);
        QTRY_COMPARE(model.step(), SiteStep::Fit);
        technician.press(Qt::Key_Return); // fit
        technician.press(Qt::Key_Return); // next
        QCOMPARE(model.step(), SiteStep::Verify);
        technician.verifyByKeys();
        technician.press(Qt::Key_Return); // record
        isRegistered(technician);
        technician.press(Qt::Key_Return); // to the overview
        QCOMPARE(model.step(), SiteStep::Overview);
        QCOMPARE(model.site().verification->operatorName, std::string{"A. Frei"});
        technician.press(Qt::Key_Return); // finish
        QVERIFY(!technician.window->isVisible());
    }

    /// A name that is typed is kept, whatever key ends it.
    void keepsANameThatReturnEnds()
    {
        Technician technician{5};
        technician.model->enter(SiteStep::Overview);
        QVERIFY(technician.tabTo("operator"));
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("A. Frei"));
        technician.press(Qt::Key_Return);
        QCOMPARE(technician.model->site().operatorName, std::string{"A. Frei"});
    }
};

CARINA_SCREEN_TEST(TestWholeRegistration)

} // namespace carina::whole_registration_test

#include "tst_whole_registration.moc"
