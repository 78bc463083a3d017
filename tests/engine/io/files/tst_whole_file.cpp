#include "engine/io/files/private_file.h"
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

    void privateFileIsForItsOwnerAlone_data()
    {
        QTest::addColumn<bool>("wasThere");
        QTest::newRow("new") << false;
        QTest::newRow("was for everybody") << true;
    }
    void privateFileIsForItsOwnerAlone()
    {
        QFETCH(const bool, wasThere);
        const QTemporaryDir folder;
        QFile file{folder.filePath(QStringLiteral("journal"))};
        const std::filesystem::path path = file.fileName().toStdString();
        if (wasThere) {
            QVERIFY(writeWholeFile(path, "before"));
            std::filesystem::permissions(path, std::filesystem::perms{0644});
        }
        QVERIFY(openPrivately(file, QIODevice::WriteOnly | QIODevice::Append));
        QVERIFY(std::filesystem::status(path).permissions() == std::filesystem::perms{0600});
        QVERIFY(file.write(" after") > 0 && file.flush());
        QCOMPARE(*readWholeFile(path, kDescriptionLimit),
                 std::string{wasThere ? "before after" : " after"});
    }

    void whatIsNoFileKeepsItsMode()
    {
        const auto before = std::filesystem::status("/dev/null").permissions();
        QFile nothing{QStringLiteral("/dev/null")};
        QVERIFY(openPrivately(nothing, QIODevice::WriteOnly | QIODevice::Append));
        QVERIFY(std::filesystem::status("/dev/null").permissions() == before);
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
