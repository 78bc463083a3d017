#include "engine/io/site/site_file.h"
#include "tests/engine/io/fact_store/fact_store_files.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/support/struck_child.h"
#include "tests/support/test_class.h"

#include <iostream>

namespace carina::test::file_faults_test
{
namespace
{

constexpr std::uint64_t kFacts = 4;

std::filesystem::path storeIn(const std::filesystem::path& folder)
{
    return folder / "session.sqlite";
}

std::filesystem::path siteIn(const std::filesystem::path& folder) { return folder / "site.json"; }

/// A site that is like no other.
Site numberedSite(int number)
{
    Site site = wholeSite();
    site.operatorName = std::to_string(number);
    return site;
}

/// What the child under faults does: it stores facts and sites, each a second time where it failed,
/// and tells each that was stored.
int storeUnderFaults(int& argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const std::filesystem::path folder{argv[1]};
    auto store = openFactStore(storeIn(folder));
    if (!store)
        store = openFactStore(storeIn(folder));
    for (std::uint64_t number = 1; store && number <= kFacts; ++number) {
        const FactRecord fact = numbered(number);
        if (!append(**store, fact) && !append(**store, fact))
            break;
        std::cout << "fact " << number << std::endl;
        static_cast<void>((*store)->setClockAnchor({"boot", Duration{5}}));
        static_cast<void>((*store)->keepWhole());
    }
    if (store)
        store->reset();
    for (int number = 1; number <= 2; ++number)
        if (writeSiteFile(siteIn(folder), numberedSite(number)))
            std::cout << "site " << number << std::endl;
    return 0;
}

const TestEntry kChild{"store-under-faults", storeUnderFaults};

/// The last number that a child told of something; 0 where it told none.
int lastOf(const StruckChild& child, const QByteArray& what)
{
    const auto all = allTold(child, what);
    return all.empty() ? 0 : std::stoi(all.back());
}

} // namespace

/// Every write and sync of a store and a site file struck, one after another.
class TestFileFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void losesNothingItReported_data() { addFaultKinds(); }
    void losesNothingItReported()
    {
        QFETCH(const QString, kind);
        const auto struck = strikeEach(QStringLiteral("store-under-faults"), kind, verifyFiles);
        QVERIFY(struck && *struck >= 20);
        qInfo("%d calls struck", *struck);
    }

private:
    /// That the files have at least what was told, and nothing that nobody stored.
    static void verifyFiles(const std::filesystem::path& folder, const StruckChild& child)
    {
        const int facts = lastOf(child, "fact");
        const int site = lastOf(child, "site");
        QVERIFY(child.isStruck || (facts == int(kFacts) && site == 2));
        if (facts > 0 || std::filesystem::exists(storeIn(folder))) {
            const auto store = opened(storeIn(folder));
            QVERIFY(store);
            const auto stored = store->load();
            QVERIFY2(stored, stored ? "" : stored.error().detail.c_str());
            QVERIFY(stored->size() >= std::size_t(facts) && stored->size() <= kFacts);
            for (const FactRecord& fact : *stored)
                QVERIFY(fact == numbered(fact.number.value));
        }
        QVERIFY(!std::filesystem::exists(folder / "session_2.sqlite"));
        if (site == 0 && !std::filesystem::exists(siteIn(folder)))
            return;
        const auto read = readSiteFile(siteIn(folder));
        QVERIFY2(read, read ? "" : read.error().detail.c_str());
        QVERIFY(std::stoi(read->operatorName) >= site);
    }
};

CARINA_TEST(TestFileFaults)

} // namespace carina::test::file_faults_test

#include "tst_file_faults.moc"
