#include "engine/io/anatomy_set/set_folder.h"

#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::set_folder_test
{
namespace
{

/// What is missing in a folder that has one surface, Trachea.obj, and this manifest.
std::vector<FileFault> missingBy(const QByteArray& manifest)
{
    const test::ScratchFolder scratch;
    scratch.write("Trachea.obj", "v 0 0 0\n");
    scratch.write("MANIFEST.tsv", manifest);
    const auto folder = listSetFolder(scratch.path().toStdString());
    return folder ? missingFiles(*folder) : std::vector<FileFault>{};
}

QByteArrayList namesOf(const std::vector<FileFault>& faults)
{
    QByteArrayList names;
    for (const FileFault& fault : faults)
        names += QByteArray::fromStdString(fault.file);
    return names;
}

/// A header in which "file" is the column with this number, from 0 on, and a line below it.
QByteArray manifestWithFileAt(std::size_t column)
{
    const QByteArray tabs(qsizetype(column), '\t');
    return tabs + "file\tlicence\n" + tabs + "Lung.obj\tfree\n";
}

} // namespace

/// The files that a manifest names.
class TestSetFolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fileThatIsNamedAndNotThereIsMissing_data()
    {
        QTest::addColumn<QByteArray>("manifest");
        QTest::newRow("first column") << QByteArray{"file\tside\nTrachea.obj\tboth\nLung.obj\t\n"};
        QTest::newRow("second column") << QByteArray{"id\tfile\n1\tLung.obj\n2\tTrachea.obj\n"};
        QTest::newRow("lines of Windows") << QByteArray{"id\tfile\r\n1\tLung.obj\r\n\r\n"};
        QTest::newRow("in a folder") << QByteArray{"file\nmeshes/Trachea.obj\nLung.obj"};
        QTest::newRow("last column that is read") << manifestWithFileAt(kMostManifestColumns - 1);
    }

    void fileThatIsNamedAndNotThereIsMissing()
    {
        QFETCH(QByteArray, manifest);
        QCOMPARE(namesOf(missingBy(manifest)), QByteArrayList{"Lung.obj"});
    }

    void manifestThatNamesNoFilesIsNoFault_data()
    {
        QTest::addColumn<QByteArray>("manifest");
        QTest::newRow("without that column") << QByteArray{"id\tfiles\n1\tLung.obj\n"};
        QTest::newRow("one line") << QByteArray{"file"};
        QTest::newRow("lines that are too short") << QByteArray{"id\tfile\n1\n\n2\t\n"};
        QTest::newRow("too many columns") << manifestWithFileAt(kMostManifestColumns);
    }

    void manifestThatNamesNoFilesIsNoFault()
    {
        QFETCH(QByteArray, manifest);
        QCOMPARE(namesOf(missingBy(manifest)), QByteArrayList{});
    }

    /// For each column the header was read from its beginning: this one took hours.
    void headerOfAMillionColumnsIsReadOnce()
    {
        QCOMPARE(namesOf(missingBy(manifestWithFileAt(1 << 20))), QByteArrayList{});
    }

    /// Each fault has a sentence: those of one manifest filled the memory.
    void onlySoManyMissingFilesAreNamed()
    {
        const auto most = qsizetype(kMostMissingFiles);
        const QByteArray header{"file\n"};
        const QByteArray line{"a\n"};
        QCOMPARE(namesOf(missingBy(header + line.repeated(most))).count("a"), most);
        const auto faults = missingBy(header + line.repeated(1'000'000));
        QCOMPARE(faults.size(), std::size_t(most) + 1);
        QCOMPARE(faults.back().file, std::string{"MANIFEST.tsv"});
        QVERIFY(faults.back().error.detail.find(std::to_string(most)) != std::string::npos);
    }

    void nameThatNoFileCanHaveIsShortened()
    {
        const auto faults = missingBy("file\n" + QByteArray(1 << 20, 'a'));
        QCOMPARE(faults.size(), std::size_t{1});
        QVERIFY(faults.front().file.size() < 10'000);
        QVERIFY(faults.front().error.detail.size() < 10'000);
    }
};

CARINA_TEST(TestSetFolder)

} // namespace carina::set_folder_test

#include "tst_set_folder.moc"
