#include "engine/io/files/mapped_file.h"
#include "engine/io/files/whole_file.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <cstring>

namespace carina::mapped_file_test
{
namespace
{

std::string textOf(const MappedFile& file)
{
    std::string text(file.bytes().size(), '\0');
    std::memcpy(text.data(), file.bytes().data(), text.size());
    return text;
}

} // namespace

class TestMappedFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    [[nodiscard]] std::filesystem::path at(const char* name) const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / name;
    }

private Q_SLOTS:
    void showsEveryByte()
    {
        const std::string bytes = std::string(100'000, 'x') + '\0' + "end";
        test::writeFile(at("whole"), bytes);
        const auto mapped = MappedFile::of(at("whole"), kDescriptionLimit);
        QVERIFY(mapped);
        QVERIFY(textOf(*mapped) == bytes);
    }

    void staysWhatItWasWhenAnotherTakesItsPlace()
    {
        test::writeFile(at("replaced"), "before");
        const auto mapped = MappedFile::of(at("replaced"), kDescriptionLimit);
        QVERIFY(writeWholeFile(at("replaced"), "later"));
        QCOMPARE(textOf(*mapped), std::string{"before"});
        QCOMPARE(textOf(*MappedFile::of(at("replaced"), kDescriptionLimit)), std::string{"later"});
    }

    void movesWithItsBytes()
    {
        test::writeFile(at("one"), "one");
        test::writeFile(at("other"), "other");
        auto one = MappedFile::of(at("one"), kDescriptionLimit);
        auto other = MappedFile::of(at("other"), kDescriptionLimit);
        *one = std::move(*other);
        QCOMPARE(textOf(*one), std::string{"other"});
        const MappedFile third{std::move(*one)};
        QCOMPARE(textOf(third), std::string{"other"});
        QVERIFY(one->bytes().empty());
    }

    void saysWhyThereIsNothing()
    {
        test::writeFile(at("empty"), "");
        QCOMPARE(MappedFile::of(at("none"), kDescriptionLimit).error().code, Errc::FileNotFound);
        QCOMPARE(MappedFile::of(at("empty"), kDescriptionLimit).error().code, Errc::FileEmpty);
        const auto folder = MappedFile::of(at("."), kDescriptionLimit);
        QCOMPARE(folder.error().code, Errc::FileUnreadable);
        QVERIFY(folder.error().detail.starts_with(at(".").string()));
        QVERIFY(folder.error().detail.ends_with(": it is a folder"));
    }
};

CARINA_TEST(TestMappedFile)

} // namespace carina::mapped_file_test

#include "tst_mapped_file.moc"
