package org.teavm.classlib.java.rmi;

/** Stands for {@code java.rmi.Remote} where TeaVM compiles: a class of TLC that nobody calls implements it. */
public interface TRemote {}
