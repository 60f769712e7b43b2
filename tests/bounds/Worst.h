// SPDX-License-Identifier: MIT
// The largest share of its documented bound that an error takes, over all the inputs of a test.
#pragma once

#include "Oracle.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace Shapes::Bounds {

/// n ulp of a length are n times this times the length.
inline const CFifty g_fUlp = CFifty(0x1p-23);

class CWorst {
public:
  /// @param name  of the function; its share of the bound is printed, and a property of the test's record
  explicit CWorst(std::string name) : m_sName(std::move(name)) {}
  CWorst(const CWorst&) = delete;
  CWorst& operator=(const CWorst&) = delete;

  void See(const CFifty& error, const CFifty& bound) {
    ++m_nSeen;
    const double share = error == 0 ? 0.0 : CFifty(error / bound).convert_to<double>();
    // A NaN is an error without bound.
    if (!(share <= m_fShare)) m_fShare = share > m_fShare ? share : std::numeric_limits<double>::infinity();
  }
  void See(const CVec& is, const CVec& should, const CFifty& bound) { See(Gap(is, should), bound); }
  /// Each component, to so many ulp of it.
  void SeeEach(const Vector2& is, const CVec& should, const CFifty& ulps, const CFifty& least = 0) {
    See(abs(is.x() - should.x), ulps * g_fUlp * abs(should.x) + least);
    See(abs(is.y() - should.y), ulps * g_fUlp * abs(should.y) + least);
  }
  /// An answer that changes where `inside` is 0: a wrong one is an error of as much as that is off.
  void SeeAnswer(bool is, const CFifty& inside, const CFifty& bound) {
    See(is == (inside >= 0) ? CFifty(0) : CFifty(abs(inside)), bound);
  }

protected:
  ~CWorst() {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", m_fShare);
    std::printf("%s: worst error is %s of the bound, %d inputs\n", m_sName.c_str(), text, m_nSeen);
    testing::Test::RecordProperty(m_sName, text);
  }

  std::string m_sName;
  double m_fShare = 0.0;
  int m_nSeen = 0;
};

/// Expects when it goes out of scope that the bound held, for at least so many inputs.
class CKept : public CWorst {
public:
  CKept(std::string name, int least) : CWorst(std::move(name)), m_nLeast(least) {}
  ~CKept() {
    EXPECT_LE(m_fShare, 1.0) << m_sName;
    EXPECT_GE(m_nSeen, m_nLeast) << m_sName;
  }

private:
  int m_nLeast;
};

/// The control: expects that a naive formula did not keep the bound.
class CBroken : public CWorst {
public:
  using CWorst::CWorst;
  ~CBroken() { EXPECT_GT(m_fShare, 1.0) << m_sName; }
};

} // namespace Shapes::Bounds
