#include "engine/io/files/unused_name.h"

#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::unused_name_test
{

class TestUnusedName : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersTheNamesThatAreTaken()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file =
            std::filesystem::path{folder.path().toStdString()} / "poses.igs.mha.csv";
        QVERIFY(unusedName(file) == file);
        std::ofstream{file} << "first";
        const auto second = unusedName(file);
        QCOMPARE(second.filename().string(), std::string{"poses.igs.mha-2.csv"});
        std::ofstream{second} << "second";
        QCOMPARE(unusedName(file).filename().string(), std::string{"poses.igs.mha-3.csv"});
    }
};

CARINA_TEST(TestUnusedName)

} // namespace carina::unused_name_test

#include "tst_unused_name.moc"
