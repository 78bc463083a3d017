#include "engine/session/facts/fact_rules.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::fact_rules_test
{

class TestFactRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boundsNumbers_data();
    void boundsNumbers();
    void boundsTheStrategy();
    void knowsWhichStandingHasAReason();
    void boundsTheErrorOfARegistration();
    void boundsTheTurnOfAPlace();
    void boundsTexts_data();
    void boundsTexts();
    void namesTheValueAndItsRange();
};

} // namespace carina::fact_rules_test

namespace carina::fact_rules_test
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void numberRows(const QByteArray& what, double lowest, double highest, FactBody (*make)(double))
{
    const auto row = [&](const char* name, double value, const char* verdict) {
        QTest::newRow((what + ", " + name).constData()) << make(value) << QByteArray{verdict};
    };
    // Beyond the rounding of a change of unit, far inside what a control can show.
    constexpr double kStep = 1e-9;
    row("lowest", lowest, "fine");
    row("below", lowest * (1.0 - kStep), "out of range");
    row("in between", 0.5 * (lowest + highest), "fine");
    row("highest", highest, "fine");
    row("above", highest * (1.0 + kStep), "out of range");
    row("zero", 0.0, "out of range");
    row("negative", -lowest, "out of range");
    row("infinite", kInfinity, "not finite");
    row("negative infinite", -kInfinity, "not finite");
    row("not a number", kNaN, "not finite");
}

template <class Change> FactBody chosen(Change change)
{
    StrategyChoice choice;
    change(choice);
    return fact::StrategyChosen{choice};
}

QByteArray verdictOn(const FactBody& body)
{
    const Result<void> result = checkBody(body);
    if (result)
        return "fine";
    switch (result.error().code) {
    case Errc::OutOfRange:
        return "out of range";
    case Errc::NameUnclear:
        return "name unclear";
    case Errc::NotFinite:
        return "not finite";
    default:
        return "another error";
    }
}

} // namespace

void TestFactRules::boundsNumbers_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("verdict");
    numberRows("rate per minute", 4.0, 60.0,
               [](double v) -> FactBody { return fact::BreathingRateSet{perMinute(v)}; });
    numberRows("tidal volume in ml", 10.0, 2000.0,
               [](double v) -> FactBody { return fact::TidalVolumeSet{millilitres(v)}; });
    numberRows("inspiratory fraction", 0.1, 0.9,
               [](double v) -> FactBody { return fact::InspiratoryFractionSet{v}; });
    numberRows("lowest rate of the ASA", 0.1, 1.0, [](double v) -> FactBody {
        return chosen([v](StrategyChoice& c) { c.asa.lowest = v; });
    });
    numberRows("highest rate of the ASA", 1.0, 20.0, [](double v) -> FactBody {
        return chosen([v](StrategyChoice& c) { c.asa.highest = v; });
    });
    numberRows("first rate of the ASA", 1.0, 20.0, [](double v) -> FactBody {
        return chosen([v](StrategyChoice& c) { c.asa.start = v; });
    });
}

void TestFactRules::boundsNumbers()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, verdict);
    QCOMPARE(verdictOn(body), verdict);
}

void TestFactRules::boundsTheStrategy()
{
    const auto delays = [](std::uint16_t n) {
        return verdictOn(chosen([n](StrategyChoice& choice) { choice.asa.delays = n; }));
    };
    QCOMPARE(delays(0), QByteArray{"out of range"});
    QCOMPARE(delays(1), QByteArray{"fine"});
    QCOMPARE(delays(1000), QByteArray{"fine"});
    QCOMPARE(delays(1001), QByteArray{"out of range"});
    const auto lag = [](Duration longest) {
        return verdictOn(
            chosen([longest](StrategyChoice& choice) { choice.longestLag = longest; }));
    };
    QCOMPARE(lag(Duration{-1}), QByteArray{"out of range"});
    QCOMPARE(lag(Duration{}), QByteArray{"fine"});
    QCOMPARE(lag(kLongestLocalLag), QByteArray{"fine"});
    QCOMPARE(lag(kLongestLocalLag + Duration{1}), QByteArray{"out of range"});
}

void TestFactRules::knowsWhichStandingHasAReason()
{
    const auto stated = [](RegistrationState state, StaleReason reason) {
        return verdictOn(fact::RegistrationStated{{state, reason, {}}});
    };
    for (const auto state :
         {RegistrationState::Simulated, RegistrationState::Good, RegistrationState::NotGood,
          RegistrationState::Missing, RegistrationState::NoTracker}) {
        QCOMPARE(stated(state, StaleReason::None), QByteArray{"fine"});
        QCOMPARE(stated(state, StaleReason::Stylus), QByteArray{"out of range"});
    }
    QCOMPARE(stated(RegistrationState::Unverified, StaleReason::None), QByteArray{"fine"});
    QCOMPARE(stated(RegistrationState::Unverified, StaleReason::Fit), QByteArray{"fine"});
    QCOMPARE(stated(RegistrationState::Stale, StaleReason::None), QByteArray{"out of range"});
    QCOMPARE(stated(RegistrationState::Stale, StaleReason::Stylus), QByteArray{"fine"});
}

void TestFactRules::boundsTheErrorOfARegistration()
{
    const auto stated = [](double error_m) {
        return verdictOn(fact::RegistrationStated{
            {RegistrationState::Good, StaleReason::None, metres(error_m)}});
    };
    QCOMPARE(stated(0.0), QByteArray{"fine"}); // not known
    QCOMPARE(stated(1.0), QByteArray{"fine"});
    QCOMPARE(stated(1.001), QByteArray{"out of range"});
    QCOMPARE(stated(-1e-4), QByteArray{"out of range"});
    QCOMPARE(stated(kNaN), QByteArray{"not finite"});
}

void TestFactRules::boundsTheTurnOfAPlace()
{
    const auto turn = [](Angle angle) {
        return verdictOn(fact::PlaceChosen{ParticipantId{2}, angle});
    };
    QCOMPARE(turn(degrees(-180.0)), QByteArray{"fine"});
    QCOMPARE(turn(degrees(180.0)), QByteArray{"fine"});
    QCOMPARE(turn(degrees(180.1)), QByteArray{"out of range"});
    QCOMPARE(turn(degrees(-180.1)), QByteArray{"out of range"});
}

void TestFactRules::boundsTexts_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("verdict");
    struct Field {
        const char* name;
        FactBody (*make)(const std::string&);
    };
    const Field fields[] = {
        {"session name",
         [](const std::string& t) -> FactBody {
             return fact::SessionCreated{t, {}};
         }},
        {"session id",
         [](const std::string& t) -> FactBody {
             return fact::SessionCreated{{}, t};
         }},
        {"station", [](const std::string& t) -> FactBody { return fact::StationAdded{t}; }},
        {"station's new name",
         [](const std::string& t) -> FactBody { return fact::StationRenamed{t}; }},
        {"participant",
         [](const std::string& t) -> FactBody {
             return fact::ParticipantJoined{{}, Role::Trainee, t};
         }},
        {"reason of a removal",
         [](const std::string& t) -> FactBody {
             return fact::ParticipantRemoved{{}, false, t};
         }},
        {"object",
         [](const std::string& t) -> FactBody {
             return fact::ObjectShared{{}, {}, ObjectKind::Tube, t};
         }},
        {"anatomy hash",
         [](const std::string& t) -> FactBody {
             return fact::AnatomyChosen{t, {}};
         }},
        {"anatomy name",
         [](const std::string& t) -> FactBody {
             return fact::AnatomyChosen{{}, t};
         }},
    };
    for (const Field& field : fields) {
        const auto row = [&](const char* name, const std::string& text, const char* verdict) {
            QTest::addRow("%s, %s", field.name, name) << field.make(text) << QByteArray{verdict};
        };
        row("empty", "", "fine");
        row("64 bytes", std::string(64, 'a'), "fine");
        row("65 bytes", std::string(65, 'a'), "out of range");
        row("64 bytes in 32 characters", "\xc3\xa9" + std::string(62, 'a'), "fine");
        row("broken UTF-8", "\xc3", "out of range");
    }
    QTest::newRow("phase") << FactBody{fact::PhaseChanged{SessionPhase::Ended}}
                           << QByteArray{"fine"};
    QTest::newRow("leaving") << FactBody{fact::ParticipantLeft{ParticipantId{9}}}
                             << QByteArray{"fine"};
}

void TestFactRules::boundsTexts() { boundsNumbers(); }

void TestFactRules::namesTheValueAndItsRange()
{
    const auto detail = [](const FactBody& body) {
        return QString::fromStdString(checkBody(body).error().detail);
    };
    QCOMPARE(detail(fact::BreathingRateSet{perMinute(72.5)}),
             QStringLiteral("breathing rate 72.5 /min (4 to 60)"));
    QCOMPARE(detail(fact::TidalVolumeSet{millilitres(5.0)}),
             QStringLiteral("tidal volume 5 ml (10 to 2000)"));
    QCOMPARE(detail(fact::InspiratoryFractionSet{0.95}),
             QStringLiteral("inspiratory fraction 0.95 (0.1 to 0.9)"));
    QCOMPARE(detail(fact::StationAdded{std::string(70, 'a')}),
             QStringLiteral("a text of 70 bytes (64 at most)"));
}

CARINA_TEST(TestFactRules)

} // namespace carina::fact_rules_test

#include "tst_fact_rules.moc"
