#include "apps/program/options/openigtlink_option.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::openigtlink_option_test
{
namespace
{

using test::FakeSessionNode;

const SharedPatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return made;
}

/// A program with a window, and the words that it is started with.
struct Started {
    FakeSessionNode node;
    StationView view{node, FakeSessionNode::kStation, child()->lungs()};
    OfferSwitch offer{[this] { return OfferGiver::Shown{view, *child()}; }};
    QWidget window;

    Result<void> with(const QStringList& words)
    {
        window.setWindowTitle(QStringLiteral("Carina trainee"));
        QCommandLineParser parser;
        program::addOpenIgtLinkOption(parser);
        if (!parser.parse(QStringList{QStringLiteral("program")} + words))
            return fail(Errc::WrongOption, parser.errorText().toStdString());
        return program::openIgtLinkOption(parser, window, offer);
    }
};

} // namespace

class TestOpenIgtLinkOption : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void switchesOnWhatItAsksFor()
    {
        Started started;
        QVERIFY(started.with({QStringLiteral("--openigtlink"), QStringLiteral("0")}));
        QVERIFY(started.offer.isOn() && !started.offer.isOpen());
        QCOMPARE(started.window.windowTitle(), QStringLiteral("Carina trainee"));
    }

    void leavesItOffUnlessAsked()
    {
        Started started;
        QVERIFY(started.with({}));
        QVERIFY(!started.offer.isOn());
    }

    /// Also where a person opens it later, in the window.
    void theTitleSaysWhileItIsOpen()
    {
        Started started;
        QVERIFY(started.with({}));
        QVERIFY(started.offer.begin({"0.0.0.0", 0}));
        QVERIFY(started.window.windowTitle().contains(QStringLiteral("open to other computers")));
        started.offer.end();
        QCOMPARE(started.window.windowTitle(), QStringLiteral("Carina trainee"));
    }

    void refusesWhatIsNoPlace()
    {
        Started started;
        const auto refused =
            started.with({QStringLiteral("--openigtlink"), QStringLiteral("somewhere")});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::WrongOption);
        QVERIFY(!started.offer.isOn());
    }
};

CARINA_SCREEN_TEST(TestOpenIgtLinkOption)

} // namespace carina::openigtlink_option_test

#include "tst_openigtlink_option.moc"
