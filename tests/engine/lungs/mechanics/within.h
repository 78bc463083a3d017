#pragma once

#include <QTest>

#include <cmath>

/// A tolerance has a name and the unit of what it is compared in.
#define VERIFY_WITHIN(actual, expected, tolerance)                                                 \
    do {                                                                                           \
        const double is = (actual);                                                                \
        const double ought = (expected);                                                           \
        QVERIFY2(                                                                                  \
            std::abs(is - ought) <= (tolerance),                                                   \
            qPrintable(                                                                            \
                QStringLiteral("%1 instead of %2").arg(is, 0, 'g', 10).arg(ought, 0, 'g', 10)));   \
    } while (false)
