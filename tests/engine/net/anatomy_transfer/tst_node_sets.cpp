#include "engine/net/anatomy_transfer/set_fetch.h"
#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

#include <QTcpServer>
#include <QTcpSocket>

namespace carina::node_sets_test
{
namespace
{

const QHostAddress kHere{QHostAddress::LocalHost};

bool listensOverTcp(std::uint16_t port)
{
    QTcpSocket socket;
    socket.connectToHost(kHere, port);
    return socket.waitForConnected(kPatience_ms);
}

} // namespace

/// Sets between the nodes of a session.
class TestNodeSets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_disk = std::make_unique<MemoryDisk>();
        m_root = m_disk->folder.path().toStdString();
        test::importInto(m_root / "host", test::carriedSample());
    }
    void cleanup() { m_host.reset(); }

    void participantFetchesWhatItsStationHas()
    {
        serve();
        m_host->propose(kStation, fact::AnatomyChosen{test::kSetHash, "Somebody"});
        const auto trainee = join(*m_host, "Tom");
        QTRY_VERIFY_WITH_TIMEOUT(trainee->door().has_value(), kPatience_ms);
        QCOMPARE(trainee->door()->port, m_host->port());
        QCOMPARE(trainee->door()->address, std::string{"127.0.0.1"});
        QTRY_VERIFY_WITH_TIMEOUT(isChosen(*trainee), kPatience_ms);
        const SetFetch fetch{*trainee->door(), test::kSetHash, m_root / "here"};
        QTRY_VERIFY_WITH_TIMEOUT(fetch.status().state == FetchStatus::State::Here, kPatience_ms);
        QVERIFY(CarriedSets{m_root / "here"}.load(fetch.status().set.digest, test::kSetHash));
    }

    void doorOpensWithTheTokenOnceThereIsOne()
    {
        serve();
        m_host->propose(kStation, fact::AnatomyChosen{test::kSetHash, "Somebody"});
        const auto trainee = join(*m_host, "Tom");
        const auto hasToken = [&] {
            const auto door = trainee->door();
            return door && door->offer.identity.who.participant == trainee->self();
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasToken(), kPatience_ms);
        const SetFetch fetch{*trainee->door(), test::kSetHash, m_root / "here"};
        QTRY_VERIFY_WITH_TIMEOUT(fetch.status().state == FetchStatus::State::Here, kPatience_ms);
    }

    void setsThatNoStationHasStayAtTheHost()
    {
        serve();
        const auto trainee = join(*m_host, "Tom");
        QTRY_VERIFY_WITH_TIMEOUT(trainee->door().has_value(), kPatience_ms);
        const SetFetch fetch{*trainee->door(), test::kSetHash, m_root / "here"};
        QTRY_VERIFY_WITH_TIMEOUT(fetch.status().state == FetchStatus::State::Failed, kPatience_ms);
        QVERIFY(fetch.status().fault->code == Errc::SetNotNamed);
    }

    void removedParticipantIsSentNothing()
    {
        serve();
        m_host->propose(kStation, fact::AnatomyChosen{test::kSetHash, "Somebody"});
        const auto trainee = join(*m_host, "Tom");
        const auto hasToken = [&] {
            const auto door = trainee->door();
            return door && door->offer.identity.who.participant == trainee->self();
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasToken(), kPatience_ms);
        const HostDoor door = *trainee->door();
        const ParticipantId id = trainee->self();
        m_host->propose(kStation, fact::ParticipantRemoved{id, false, "too loud"});
        QTRY_VERIFY_WITH_TIMEOUT(m_host->state()->participants().at(id).removal.has_value(),
                                 kPatience_ms);
        const SetFetch fetch{door, test::kSetHash, m_root / "here"};
        QTRY_VERIFY_WITH_TIMEOUT(fetch.status().fault.has_value(), kPatience_ms);
        QVERIFY(fetch.status().fault->code == Errc::HostSilent);
        QVERIFY(fetch.status().state == FetchStatus::State::Asking);
    }

    void nothingListensWhereThereIsNothingToHandOut()
    {
        m_host = host(*m_disk);
        QVERIFY(!listensOverTcp(m_host->port()));
        QVERIFY(!m_host->door());
    }

    void listensOnLoopbackAloneUntilItIsOpened()
    {
        serve();
        QVERIFY(listensOverTcp(m_host->port()));
        // Any other address of this computer is free to be bound by somebody else.
        QTcpServer other;
        QVERIFY(other.listen(QHostAddress{QStringLiteral("127.0.0.2")}, m_host->port()));
        other.close();
        m_host.reset();
        m_disk = std::make_unique<MemoryDisk>();
        serve(0, true);
        QVERIFY(!other.listen(QHostAddress{QStringLiteral("127.0.0.2")}, m_host->port()));
    }

    void portThatIsTakenForTcpIsNamed()
    {
        QTcpServer other;
        QVERIFY(other.listen(kHere, 0));
        const auto node = SessionNode::host(settings(other.serverPort(), false),
                                            std::make_unique<MemoryStore>(*m_disk));
        QVERIFY(!node && node.error().code == Errc::AddressInUse);
        QVERIFY(m_disk->facts.empty()); // nothing was begun
    }

private:
    [[nodiscard]] HostSettings settings(std::uint16_t port, bool open) const
    {
        HostSettings settings = hostSettings(*m_disk, port);
        settings.open = open;
        settings.anatomyCache = m_root / "host";
        return settings;
    }
    void serve(std::uint16_t port = 0, bool open = false)
    {
        m_host = *SessionNode::host(settings(port, open), std::make_unique<MemoryStore>(*m_disk));
    }
    static bool isChosen(const SessionNode& node)
    {
        const auto state = node.state();
        const auto station = state->stations().find(kStation);
        return station != state->stations().end() && station->second.anatomyHash == test::kSetHash;
    }

    std::unique_ptr<MemoryDisk> m_disk;
    std::filesystem::path m_root;
    std::unique_ptr<SessionNode> m_host;
};

CARINA_TEST(TestNodeSets)

} // namespace carina::node_sets_test

#include "tst_node_sets.moc"
