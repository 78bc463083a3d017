#include "engine/io/files/whole_file.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::whole_file_test
{

class TestWholeFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void folderIsMadeWithThoseAboveItAndLeftEmpty()
    {
        const QTemporaryDir above;
        const QDir folder{above.filePath(QStringLiteral("a/b"))};
        QVERIFY(openFolder(folder.path().toStdString()));
        QVERIFY(folder.exists());
        QVERIFY(folder.isEmpty());
        QVERIFY(openFolder(folder.path().toStdString())); // and that one is there
    }

    void bareNameIsAFileOfTheCurrentFolder()
    {
        const QTemporaryDir folder;
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder.path()));
        const bool opened = openFolder({}).has_value();
        const bool written = writeWholeFile("site.json", "x").has_value();
        const bool kept = writePrivateFile("key", "y").has_value();
        QVERIFY(QDir::setCurrent(before));
        QVERIFY(opened && written && kept);
        QCOMPARE(*readWholeFile(folder.filePath(QStringLiteral("site.json")).toStdString(),
                                kDescriptionLimit),
                 std::string{"x"});
        QCOMPARE(
            *readWholeFile(folder.filePath(QStringLiteral("key")).toStdString(), kDescriptionLimit),
            std::string{"y"});
    }

    void folderThatTakesNothingIsNamed()
    {
        const QTemporaryDir above;
        const std::string file = above.filePath(QStringLiteral("file")).toStdString();
        QVERIFY(writeWholeFile(file, "x"));
        for (const std::string& folder : {file, file + "/below"}) {
            const auto opened = openFolder(folder);
            QVERIFY(!opened);
            QCOMPARE(opened.error(),
                     (Error{Errc::FileUnwritable, folder + ": nothing can be written into it"}));
        }
    }
};

CARINA_TEST(TestWholeFile)

} // namespace carina::whole_file_test

#include "tst_whole_file.moc"
