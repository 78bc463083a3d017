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

/// One thing that a test program runs when its command line begins with the name. A program holds
/// the test classes of one folder; each call runs one of them, in a process of its own.
class TestEntry
{
public:
    using Run = int (*)(int& argc, char** argv); ///< argv[0] is the program, then its arguments

    /// @param name what to ask for. Of a path, "tests/engine/core/tst_ids.cpp", the part that
    ///             names the test: "ids".
    TestEntry(std::string_view name, Run run);

    /// Runs the entry that argv[1] names on the arguments after it. Names all entries on stderr and
    /// returns 2 where there is none of that name.
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

/// Enters a test class into its program, under the name of its file. It runs with a
/// QCoreApplication.
#define CARINA_TEST(Class)                                                                         \
    static const carina::test::TestEntry entryOf##Class{                                           \
        __FILE__, carina::test::runTestClass<Class, QCoreApplication>};

/// The same with the application that windows, or fonts and pictures, need.
#define CARINA_SCREEN_TEST(Class)                                                                  \
    static const carina::test::TestEntry entryOf##Class{                                           \
        __FILE__, carina::test::runTestClass<Class, carina::test::ScreenApplication>};
