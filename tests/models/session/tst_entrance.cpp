#include "engine/net/node/session_node.h"
#include "models/errors/error_text.h"
#include "models/session/entrance.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::entrance_test
{

using namespace test;

/// Coming in, with a host that a test answers for.
class TestEntrance : public QObject
{
    Q_OBJECT

private:
    static JoinForm form()
    {
        return {QStringLiteral("192.0.2.7"), QStringLiteral("45000"), QStringLiteral("7K3QM-XW2PD"),
                QStringLiteral("Anna"), Role::Observer};
    }
    Entrance::Join join()
    {
        return [this](const JoinSettings& settings) -> Result<std::unique_ptr<SessionNode>> {
            m_tried.push_back(settings);
            auto node = std::make_unique<FakeSessionNode>(kNobody);
            m_node = node.get();
            return node;
        };
    }

    std::vector<JoinSettings> m_tried;
    FakeSessionNode* m_node = nullptr;

private Q_SLOTS:
    void init() { m_tried.clear(); }

    void triesWhatWasTypedWithWhatIsKnown()
    {
        JoinSettings known;
        known.station = "Room 9"; // what was typed counts
        known.tokens = "kept";
        Entrance entrance{known, join()};
        QVERIFY(!entrance.isTrying());
        QCOMPARE(entrance.progress(), QString{});
        JoinForm typed = form();
        typed.station = QStringLiteral("Room 3");
        entrance.enter(typed);
        QVERIFY(entrance.isTrying());
        QCOMPARE(m_tried.size(), std::size_t{1});
        QCOMPARE(m_tried[0].address, std::string{"192.0.2.7"});
        QVERIFY(m_tried[0].role == Role::Observer);
        QCOMPARE(m_tried[0].station, std::string{"Room 3"});
        QCOMPARE(m_tried[0].tokens.string(), std::string{"kept"});
        QVERIFY(entrance.settings().role == Role::Observer);
    }

    void handsOverTheWayInOnceTheHostLetItIn()
    {
        Entrance entrance{{}, join()};
        const QSignalSpy changes{&entrance, &Entrance::changed};
        entrance.enter(form());
        entrance.look();
        QVERIFY(!entrance.isIn());
        m_node->becomes(FakeSessionNode::kObserver);
        entrance.look();
        QVERIFY(entrance.isIn() && !entrance.isTrying());
        QCOMPARE(changes.size(), 3);
        QVERIFY(entrance.take().get() == m_node);
        QVERIFY(!entrance.isIn());
    }

    void saysWhyItWasRefusedAndTriesAgain()
    {
        Entrance entrance{{}, join()};
        entrance.enter(form());
        m_node->isRefused({Errc::WrongCode, "7K3QM-XW2PD"});
        entrance.look();
        QVERIFY(!entrance.isTrying() && !entrance.isIn());
        QCOMPARE(entrance.refusal()->field, JoinField::Code);
        QCOMPARE(entrance.refusal()->sentence, errorText({Errc::WrongCode, "7K3QM-XW2PD"}));
        entrance.enter(form());
        QVERIFY(entrance.isTrying() && !entrance.refusal());
        QCOMPARE(m_tried.size(), std::size_t{2});
    }

    void nameIsTakenOnlyIfItStaysSo()
    {
        Entrance entrance{{}, join()};
        entrance.enter(form());
        m_node->isRefused({Errc::NameTaken, {}});
        for (int i = 1; i < Entrance::kTakenBelieved; ++i)
            entrance.look();
        QVERIFY(entrance.isTrying());
        entrance.look();
        QVERIFY(!entrance.isTrying());
        QCOMPARE(entrance.refusal()->field, JoinField::Name);
    }

    void refusalOfWhatItDidOnceInsideDoesNotLeadOut()
    {
        Entrance entrance{{}, join()};
        entrance.enter(form());
        m_node->isRefused({Errc::NotPermitted, {}});
        m_node->becomes(FakeSessionNode::kObserver);
        entrance.look();
        QVERIFY(entrance.isIn() && !entrance.refusal());
    }

    void whatNoNodeCanBeMadeOfIsRefusedAtOnce()
    {
        Entrance entrance{{}, [](const JoinSettings&) -> Result<std::unique_ptr<SessionNode>> {
                              return fail(Errc::FileNotFound, "hospital.pem");
                          }};
        entrance.enter(form());
        QVERIFY(!entrance.isTrying());
        QCOMPARE(entrance.refusal()->sentence, errorText({Errc::FileNotFound, "hospital.pem"}));
    }

    void stopsWhenItsPersonDoes()
    {
        Entrance entrance{{}, join()};
        entrance.enter(form());
        entrance.stop();
        QVERIFY(!entrance.isTrying() && !entrance.isIn() && !entrance.refusal());
        entrance.look();
        QVERIFY(!entrance.isTrying());
    }

    void saysWhereToLookWhenNobodyAnswers()
    {
        Entrance entrance{{}, join()};
        entrance.enter(form());
        for (int i = 1; i < Entrance::kPatience; ++i)
            entrance.look();
        QCOMPARE(entrance.progress(), QStringLiteral("Joining …"));
        entrance.look();
        QVERIFY(entrance.progress().contains(QStringLiteral("compare address and port")));
        entrance.stop();
        entrance.enter(form());
        QCOMPARE(entrance.progress(), QStringLiteral("Joining …"));
    }

    /// However long that took: the console lists them.
    void saysThatItIsConnected()
    {
        const QString connected = QStringLiteral("Connected; waiting for the patient");
        Entrance entrance{{}, join()};
        entrance.enter(form());
        for (int i = 0; i < Entrance::kPatience; ++i)
            entrance.look();
        m_node->linkReports = {{FakeSessionNode::kHost, LinkState::Connecting, {}, {}, {}}};
        QVERIFY(entrance.progress() != connected);
        m_node->linkReports[0].state = LinkState::Connected;
        QCOMPARE(entrance.progress(), connected);
        m_node->becomes(FakeSessionNode::kObserver);
        entrance.look();
        QCOMPARE(entrance.progress(), connected);
        static_cast<void>(entrance.take());
        QCOMPARE(entrance.progress(), QString{});
    }
};

CARINA_TEST(TestEntrance)

} // namespace carina::entrance_test

#include "tst_entrance.moc"
