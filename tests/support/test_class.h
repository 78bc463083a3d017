#pragma once

#include <QTest>

#include <string_view>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
#endif

namespace carina::test
{

/// One entry of a test program, selected by its name as the first argument. A program has the test
/// classes of one folder; each process runs one of them.
class TestEntry
{
public:
    using Run = int (*)(int& argc, char** argv); ///< argv[0] is the program, then its arguments

    /// @param name the name of the entry; from a path, "tests/engine/core/tst_ids.cpp", the name
    ///             "ids" is taken.
    TestEntry(std::string_view name, Run run);

    /// Runs the entry named by argv[1] with the arguments after it. If there is none of that name,
    /// lists all entries on stderr and returns 2.
    static int runNamed(int argc, char** argv);
};

template <class Class, class Application> int runTestClass(int& argc, char** argv)
{
    if constexpr (requires { Class::initMain(); })
        Class::initMain(); // before there is an application
    const Application application{argc, argv};
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // pictures do not depend on the screen
    Class test;
    return QTest::qExec(&test, argc, argv);
}

#ifdef QT_WIDGETS_LIB
using ScreenApplication = QApplication;
#elif defined(QT_GUI_LIB)
using ScreenApplication = QGuiApplication;
#endif

} // namespace carina::test

/// Registers a test class in its program, under the name of its file. It runs with a
/// QCoreApplication.
#define CARINA_TEST(Class)                                                                         \
    static const carina::test::TestEntry entryOf##Class{                                           \
        __FILE__, carina::test::runTestClass<Class, QCoreApplication>};

/// The same with a QApplication or QGuiApplication, for windows or for fonts and pictures.
#define CARINA_SCREEN_TEST(Class)                                                                  \
    static const carina::test::TestEntry entryOf##Class{                                           \
        __FILE__, carina::test::runTestClass<Class, carina::test::ScreenApplication>};
