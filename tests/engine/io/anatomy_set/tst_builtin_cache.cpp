#include "engine/io/anatomy_set/builtin_cache.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::builtin_cache_test
{

class TestBuiltinCache : public QObject
{
    Q_OBJECT

    static bool same(const Anatomy& a, const Anatomy& b)
    {
        if (a.name != b.name || a.contentHash != b.contentHash || a.parts.size() != b.parts.size()
            || a.landmarks.path_A != b.landmarks.path_A)
            return false;
        for (std::size_t i = 0; i < a.parts.size(); ++i) {
            if (a.parts[i].name != b.parts[i].name || a.parts[i].role != b.parts[i].role
                || a.parts[i].levels.size() != b.parts[i].levels.size())
                return false;
            for (std::size_t k = 0; k < a.parts[i].levels.size(); ++k)
                if (a.parts[i].levels[k].positions != b.parts[i].levels[k].positions
                    || a.parts[i].levels[k].triangles != b.parts[i].levels[k].triangles)
                    return false;
        }
        return true;
    }

private Q_SLOTS:
    void keepsWhatItMadeAndGivesTheSameAgain()
    {
        const QTemporaryDir temporary;
        const std::filesystem::path folder = temporary.path().toStdString();
        const auto made = cachedPatient(parametersOf(BuiltinPatient::TwelveYears), folder);
        QVERIFY(made.has_value());
        const AnatomyCache cache{folder};
        const std::filesystem::path file = cache.setFile("builtin-twelve-years-12");
        QVERIFY(std::filesystem::exists(file));
        const auto kept = cachedPatient(parametersOf(BuiltinPatient::TwelveYears), folder);
        QVERIFY(kept.has_value());
        QVERIFY(same(*made, *kept));

        // A damaged file is not used, and is written anew.
        std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
        const auto again = cachedPatient(parametersOf(BuiltinPatient::TwelveYears), folder);
        QVERIFY(again.has_value());
        QVERIFY(same(*made, *again));
        QVERIFY(cache.load("builtin-twelve-years-12").has_value());
    }

    void takesWhatIsInTheCache()
    {
        const QTemporaryDir temporary;
        const std::filesystem::path folder = temporary.path().toStdString();
        ImportedSet marked;
        marked.anatomy.attributions = {"marked"};
        marked.anatomy.contentHash = "builtin-adult-12";
        QVERIFY(AnatomyCache{folder}.store(marked).has_value());
        const auto taken = cachedPatient(parametersOf(BuiltinPatient::Adult), folder);
        QCOMPARE(taken->attributions, std::vector<std::string>{"marked"});
        QCOMPARE(taken->name, std::string{"Adult"}); // as this program calls it
    }

    void makesThePatientWhereNothingCanBeKept()
    {
        const QTemporaryDir temporary;
        const std::filesystem::path folder = temporary.path().toStdString() + "/taken";
        std::ofstream{folder} << "a file where a folder is wanted";
        const auto made = cachedPatient(parametersOf(BuiltinPatient::TwelveYears), folder);
        QVERIFY(made.has_value());
        QCOMPARE(made->contentHash, std::string{"builtin-twelve-years-12"});
    }
};

CARINA_TEST(TestBuiltinCache)

} // namespace carina::builtin_cache_test

#include "tst_builtin_cache.moc"
