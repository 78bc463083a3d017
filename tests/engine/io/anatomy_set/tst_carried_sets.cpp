#include "engine/io/anatomy_set/carried_sets.h"

#include "engine/io/anatomy_set/set_codec.h"
#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <csignal>
#include <sys/resource.h>

namespace carina::carried_sets_test
{
namespace
{

/// The disk takes no file longer than this, until the end of the block.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit less{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &less);
        std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before{};
};

} // namespace

/// Host and receiver each have a cache folder of their own.
class TestCarriedSets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_host = m_folder->path().toStdString() + "/host";
        m_here = m_folder->path().toStdString() + "/here";
        test::importInto(m_host, test::carriedSample(1000));
        const auto prepared = CarriedSets{m_host}.prepare(test::kSetHash);
        QVERIFY2(prepared, prepared ? "" : prepared.error().detail.c_str());
        m_set = *prepared;
        m_bytes = test::contentOf(CarriedSets{m_host}.file(m_set.digest));
    }

    void namesASetByTheHashOfItsBytes()
    {
        QCOMPARE(QByteArray::fromStdString(m_set.digest),
                 QCryptographicHash::hash(m_bytes, QCryptographicHash::Blake2b_256).toHex());
        QCOMPARE(m_set.bytes, std::uint64_t(m_bytes.size()));
        QCOMPARE(m_set.licence, std::string{"CC0\nby Somebody"});
        QVERIFY(CarriedSets{m_host}.has(m_set));
        QVERIFY(!CarriedSets{m_here}.has(m_set));
    }

    void carriesAllButWhatTheImportSaidOfFiles()
    {
        const auto set = CarriedSets{m_host}.load(m_set.digest, test::kSetHash);
        QVERIFY2(set, set ? "" : set.error().detail.c_str());
        QCOMPARE(set->anatomy.parts[0].levels[0].triangles.size(), std::size_t{4000});
        QCOMPARE(set->anatomy.attributions.size(), std::size_t{2});
        QVERIFY(set->faults.empty());
        QVERIFY(set->leftOut.empty());
        QVERIFY(!m_bytes.contains("/folder/of/the/host"));
    }

    void preparesTheSameBytesAgain()
    {
        std::filesystem::remove_all(m_host / "carried");
        const auto again = CarriedSets{m_host}.prepare(test::kSetHash);
        QVERIFY(again && again->digest == m_set.digest);
        QVERIFY(CarriedSets{m_host}.has(m_set));
    }

    void cutsALicenceBetweenCharacters()
    {
        ImportedSet set = test::carriedSample();
        set.anatomy.attributions = {std::string(1023, 'x') + "é"};
        test::importInto(m_host, set);
        QCOMPARE(CarriedSets{m_host}.prepare(test::kSetHash)->licence, std::string(1023, 'x'));
        set.anatomy.attributions = {std::string(1022, 'x') + "é"};
        test::importInto(m_host, set);
        QCOMPARE(CarriedSets{m_host}.prepare(test::kSetHash)->licence,
                 std::string(1022, 'x') + "é");
    }

    void saysThatASetIsNotThere()
    {
        QVERIFY(CarriedSets{m_host}.prepare(std::string(64, 'b')).error().code
                == Errc::FileNotFound);
        QVERIFY(CarriedSets{m_host}.prepare("builtin-adult-12").error().code == Errc::FileNotFound);
        QVERIFY(CarriedSets{m_here}.load(m_set.digest, test::kSetHash).error().code
                == Errc::FileNotFound);
    }

    void isHereOnceAllOfItCame()
    {
        const CarriedSets here{m_here};
        auto partial = *here.resume(m_set);
        QCOMPARE(partial->bytes(), std::uint64_t{0});
        for (qsizetype at = 0; at < m_bytes.size(); at += 10'000) {
            QVERIFY(!here.has(m_set));
            QVERIFY(partial->append(test::bytesOf(m_bytes.mid(at, 10'000))));
        }
        QCOMPARE(partial->bytes(), m_set.bytes);
        QVERIFY(!here.has(m_set)); // not before it was looked at
        QVERIFY(partial->finish());
        QVERIFY(here.has(m_set));
        QVERIFY(here.load(m_set.digest, test::kSetHash));
    }

    void goesOnWhereItBrokeOff()
    {
        const CarriedSets here{m_here};
        {
            auto partial = *here.resume(m_set);
            QVERIFY(partial->append(test::bytesOf(m_bytes.first(12'345))));
        }
        auto partial = *here.resume(m_set);
        QCOMPARE(partial->bytes(), std::uint64_t{12'345});
        QVERIFY(partial->append(test::bytesOf(m_bytes.sliced(12'345))));
        QVERIFY(partial->finish());
        QVERIFY(here.load(m_set.digest, test::kSetHash));
    }

    void keepsNothingOfWhatIsNotAsPromised()
    {
        const CarriedSets here{m_here};
        m_bytes[5000] = static_cast<char>(m_bytes[5000] ^ 1);
        auto partial = *here.resume(m_set);
        QVERIFY(partial->append(test::bytesOf(m_bytes)));
        const auto finished = partial->finish();
        QVERIFY(!finished && finished.error().code == Errc::FileMalformed);
        QVERIFY(!here.has(m_set));
        partial.reset();
        QCOMPARE((*here.resume(m_set))->bytes(), std::uint64_t{0});
    }

    void beginsAnewWhereMoreLiesThanThereCanBe()
    {
        const CarriedSets here{m_here};
        {
            auto partial = *here.resume(m_set);
            QVERIFY(partial->append(test::bytesOf(m_bytes + 'x')));
        }
        QCOMPARE((*here.resume(m_set))->bytes(), std::uint64_t{0});
    }

    void isWrittenByOneProgramAtATime()
    {
        const CarriedSets here{m_here};
        auto first = *here.resume(m_set);
        QVERIFY(*CarriedSets{m_here}.resume(m_set) == nullptr);
        QVERIFY(first->append(test::bytesOf(m_bytes)));
        QVERIFY(first->finish());
        first.reset();
        QVERIFY(*here.resume(m_set) == nullptr); // it is there
    }

    void saysThatTheDiskIsFull()
    {
        const CarriedSets here{m_here};
        auto partial = *here.resume(m_set);
        const FullDisk full{20'000};
        const auto kept = partial->append(test::bytesOf(m_bytes));
        QVERIFY(!kept && kept.error().code == Errc::FileUnwritable);
        QCOMPARE(partial->bytes(), std::uint64_t{20'000}); // what went in stays
    }

    void saysThatTheDiskHasNoRoomForTheRest()
    {
        constexpr std::uint64_t kRoom = 40'000;
        const CarriedSets here{m_here, [](const std::filesystem::path&) { return kRoom; }};
        const auto refused = here.resume(m_set);
        QVERIFY(!refused && refused.error().code == Errc::FileUnwritable);
        {
            auto partial = *CarriedSets{m_here}.resume(m_set);
            QVERIFY(
                partial->append(test::bytesOf(m_bytes.first(qsizetype(m_set.bytes - kRoom) - 1))));
        }
        QVERIFY(!here.resume(m_set)); // a byte too many
        QVERIFY((*CarriedSets{m_here}.resume(m_set))->append(test::bytesOf(QByteArray(1, 'x'))));
        QVERIFY(here.resume(m_set));
    }

    void refusesAFileThatWasChangedOrIsAnother()
    {
        const CarriedSets host{m_host};
        QVERIFY(host.load(m_set.digest, std::string(64, 'b')).error().code == Errc::FileMalformed);
        m_bytes[5000] = static_cast<char>(m_bytes[5000] ^ 1);
        test::putContent(host.file(m_set.digest), m_bytes);
        QVERIFY(host.load(m_set.digest, test::kSetHash).error().code == Errc::FileMalformed);
    }

    void refusesASetThatCannotBeDrawn()
    {
        ImportedSet set = test::carriedSample();
        set.anatomy.parts[0].levels[0].positions[1].x() = std::nanf("");
        test::importInto(m_host, set);
        const CarriedSets host{m_host};
        const auto prepared = host.prepare(test::kSetHash);
        QVERIFY(prepared);
        QVERIFY(host.load(prepared->digest, test::kSetHash).error().code == Errc::FileMalformed);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_host;
    std::filesystem::path m_here;
    CarriedSet m_set;
    QByteArray m_bytes; // of the set as it is carried
};

CARINA_TEST(TestCarriedSets)

} // namespace carina::carried_sets_test

#include "tst_carried_sets.moc"
