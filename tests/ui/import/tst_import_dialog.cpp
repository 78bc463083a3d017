#include "models/patient/set_words.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"
#include "ui/import/import_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

#include <set>

namespace carina::import_dialog_test
{
namespace
{

/// A set of two surfaces and a broken file, on its way in.
struct Importing {
    QTemporaryDir folder;
    std::filesystem::path set = folder.path().toStdString() + "/Somebody";
    std::unique_ptr<SetImport> import;
    std::unique_ptr<ImportDialog> dialog;

    explicit Importing(float trachea = 100.0F)
    {
        test::writeFile(set / "Trachea.obj", test::objOf({trachea, -5.0F, -5.0F, 1300.0F}));
        test::writeFile(set / "blob.obj", test::objOf({200.0F, 20.0F, -50.0F, 1100.0F}));
        test::writeFile(set / "broken.obj", "v 1 2\n");
        begin();
    }
    void begin()
    {
        dialog.reset();
        import = std::make_unique<SetImport>(set, folder.path().toStdString() + "/cache");
        dialog = std::make_unique<ImportDialog>(*import);
        dialog->show();
    }
    [[nodiscard]] bool isReviewed() const
    {
        return QTest::qWaitFor([this] { return use()->isEnabled(); }, kPatience_ms);
    }
    [[nodiscard]] bool ends() const
    {
        return QTest::qWaitFor([this] { return !dialog->isVisible(); }, kPatience_ms);
    }
    template <class Control> [[nodiscard]] Control* control(const char* name) const
    {
        return dialog->findChild<Control*>(QLatin1String{name});
    }
    [[nodiscard]] QPushButton* use() const { return control<QPushButton>("use"); }
    [[nodiscard]] QComboBox* role(int row) const
    {
        return qobject_cast<QComboBox*>(control<QTableWidget>("surfaces")->cellWidget(row, 2));
    }
};

} // namespace

class TestImportDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhatEachSurfaceWasTakenFor()
    {
        const Importing in;
        QVERIFY(in.isReviewed());
        const auto* surfaces = in.control<QTableWidget>("surfaces");
        QCOMPARE(surfaces->rowCount(), 2);
        // What was not recognised comes first.
        QCOMPARE(surfaces->item(0, 0)->text(), QStringLiteral("blob.obj: Blob"));
        QCOMPARE(in.role(0)->currentText(), QStringLiteral("Something else"));
        QCOMPARE(in.role(1)->currentText(), QStringLiteral("Trachea"));
        QCOMPARE(in.control<QComboBox>("unit")->currentText(), QStringLiteral("millimetres"));
        QCOMPARE(in.control<QComboBox>("axes")->currentText(),
                 QStringLiteral("x left, y posterior, z superior"));
        QVERIFY(in.control<QLabel>("faults")->text().contains(QStringLiteral("broken.obj")));
        // Nothing goes on while the person reads.
        QVERIFY(!in.dialog->findChild<QProgressBar*>()->isVisible());
    }

    void importsAsThePersonSays()
    {
        const Importing in;
        QVERIFY(in.isReviewed());
        in.role(0)->setCurrentText(QStringLiteral("Left lung, whole"));
        QTest::keyClick(in.use(), Qt::Key_Space);
        QVERIFY(in.ends());
        QCOMPARE(in.dialog->result(), int(QDialog::Accepted));
        const auto& parts = in.import->result()->set.anatomy.parts;
        QCOMPARE(parts.size(), std::size_t{2});
        QVERIFY(parts[1].role == PartRole::LeftLung);
        QCOMPARE(in.import->result()->set.faults.size(), std::size_t{1});
    }

    void asksForTheUnitWhereNoneFits()
    {
        const Importing in{2500.0F};
        QVERIFY(in.isReviewed());
        QVERIFY(in.control<QLabel>("step")->text().contains(QStringLiteral("In no usual unit")));
        in.control<QComboBox>("axes")->setCurrentText(
            QStringLiteral("x right, y anterior, z superior"));
        in.use()->click();
        QVERIFY(in.ends());
        QCOMPARE(in.import->result()->set.frame.metresPerUnit, 1e-3);
        QVERIFY(in.import->result()->set.frame.R_AF(0, 0) == -1.0);
    }

    void leavesOutWhatThePersonDoesNotWant()
    {
        const Importing in;
        QVERIFY(in.isReviewed());
        in.role(0)->setCurrentIndex(in.role(0)->count() - 1);
        in.use()->click();
        QVERIFY(in.ends());
        QCOMPARE(in.import->result()->set.anatomy.parts.size(), std::size_t{1});
    }

    void stopsDuringTheReview()
    {
        const Importing in;
        QVERIFY(in.isReviewed());
        QTest::keyClick(in.dialog.get(), Qt::Key_Escape);
        QVERIFY(in.ends());
        QCOMPARE(in.dialog->result(), int(QDialog::Rejected));
        QCOMPARE(in.import->result().error().code, Errc::Cancelled);
    }

    void stopsWhileItReads()
    {
        const Importing in;
        in.dialog->reject();
        QVERIFY(in.ends());
        QCOMPARE(in.import->result().error().code, Errc::Cancelled);
    }

    void endsByItselfWhereTheSetIsInTheCache()
    {
        Importing in;
        QVERIFY(in.isReviewed());
        in.use()->click();
        QVERIFY(in.ends());
        in.begin();
        QVERIFY(in.ends());
        QVERIFY(in.import->result()->fromCache);
    }

    void stopsWithItsOwner()
    {
        QTemporaryDir folder;
        const std::filesystem::path set = folder.path().toStdString() + "/Somebody";
        test::writeFile(set / "Trachea.obj", test::objOf({100.0F}));
        SetImport import{set, folder.path().toStdString() + "/cache"};
        QSignalSpy asked{&import, &SetImport::reviewed};
        import.start();
        QVERIFY(asked.wait(kPatience_ms)); // and nobody answers
    }

    void findsSurfacesByWords()
    {
        const Importing in;
        QVERIFY(in.isReviewed());
        in.control<QLineEdit>("words")->setText(QStringLiteral("trach"));
        QVERIFY(in.control<QTableWidget>("surfaces")->isRowHidden(0));
        QVERIFY(!in.control<QTableWidget>("surfaces")->isRowHidden(1));
    }

    void hasAWordForEveryRole()
    {
        std::set<QString> words;
        for (const PartRole role : allRoles())
            words.insert(roleWord(role));
        QCOMPARE(words.size(), std::size_t(PartRole::Other) + 1);
        QVERIFY(!words.contains(QString{}));
    }

    void offersEveryWayThatAxesMayPoint()
    {
        std::set<QString> words;
        for (const AxesChoice& choice : axesChoices()) {
            QCOMPARE(choice.R_AF.determinant(), 1.0);
            words.insert(choice.word);
        }
        QCOMPARE(words.size(), std::size_t{24});
        QCOMPARE(axesChoices().front().word, QStringLiteral("x left, y posterior, z superior"));
    }
};

CARINA_SCREEN_TEST(TestImportDialog)

} // namespace carina::import_dialog_test

#include "tst_import_dialog.moc"
